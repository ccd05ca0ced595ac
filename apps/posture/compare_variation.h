// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/point_cloud.h>

#include <string>
#include <vector>

namespace posture::app {

/// How scans arrive: "aligned" as the files are; "turned" about its middle and shifted; "scaled"
/// turned, then a thousand times as large, and its vertices in another order.
const std::vector<std::string>& variations();

struct VariedShape {
  Shape shape;
  std::vector<int> given;  ///< row of the shape -> row as given
};

/// \throws std::invalid_argument  no such variation.
VariedShape vary(const Shape& shape, const std::string& variation);

}  // namespace posture::app
