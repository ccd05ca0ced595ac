// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "byte_order.h"
#include "input.h"
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace posture {

struct PlyProperty {
  std::string name;
  Scalar type = Scalar::FLOAT;
  bool is_list = false;
  Scalar count_type = Scalar::UINT8;  ///< of a list
};

struct PlyElement {
  std::string name;
  std::size_t count = 0;
  std::vector<PlyProperty> properties;

  /// Place of the first property with one of the names, or -1.
  int find(std::initializer_list<std::string_view> names) const;
};

struct PlyHeader {
  bool ascii = false;
  ByteOrder order = ByteOrder::LITTLE;
  std::vector<PlyElement> elements;
  std::size_t size = 0;  ///< bytes up to the first element
};

PlyHeader readPlyHeader(const Input& input);

}  // namespace posture
