// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "byte_order.h"
#include "input.h"
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace posture {

struct PcdField {
  std::string name;
  Scalar type = Scalar::FLOAT;
  std::size_t count = 1;  ///< numbers
  std::size_t bytes() const { return sizeOf(type) * count; }
};

enum class PcdEncoding { ASCII, BINARY, COMPRESSED };

struct PcdHeader {
  std::vector<PcdField> fields;
  std::size_t points = 0;
  std::size_t width = 0, height = 1;  ///< width * height = points
  Eigen::Vector3d viewpoint = Eigen::Vector3d::Zero();
  PcdEncoding encoding = PcdEncoding::ASCII;
  std::size_t size = 0;  ///< bytes up to the first point

  /// Place of the first field with one of the names, or -1.
  int find(std::initializer_list<std::string_view> names) const;
  /// Bytes of a point.
  std::size_t record() const;
};

/// No count in it is larger than the file, as long as that is not compressed.
PcdHeader readPcdHeader(const Input& input);

}  // namespace posture
