// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <vector>

namespace posture {

/// Of two places as far as rounding can tell the first is taken: the next must be so much farther.
constexpr double FARTHER_BEYOND_ROUNDING = 1 + 1e-6;

/// What a polygon says of where it lies.
struct PolygonFrame {
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero();
  Eigen::Vector3d area = Eigen::Vector3d::Zero();  ///< area vector
  double fan_area = 0;  ///< of the triangles from the centroid, without sign
  double radius = 0;    ///< root mean square distance of the corners from the centroid

  explicit PolygonFrame(const std::vector<Eigen::Vector3d>& corners);

  Eigen::Vector3d normal() const { return area.normalized(); }
};

/// Two directions across the normal; the first towards the corner that is farthest from the
/// centroid when seen along the normal. Third column: the normal.
Eigen::Matrix3d polygonAxes(const PolygonFrame& frame, const std::vector<Eigen::Vector3d>& corners);

}  // namespace posture
