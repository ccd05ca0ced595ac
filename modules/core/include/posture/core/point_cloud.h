// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/types.h>

#include <optional>

namespace posture {

/// What a scanner delivers, in any frame and unit.
struct PointCloud {
  Points points;   ///< n x 3; a row that is not finite: nothing was seen there
  Points normals;  ///< n x 3, of any sign and length, or 0 x 3
  Colors colors;   ///< n x 3, or 0 x 3
  /// Columns of the depth image, its rows one after the other; 0: the points are no grid.
  int width = 0;
  std::optional<Eigen::Vector3d> sensor;  ///< where the scanner of one view stood, as it is said
};

/// A shape as it was given: a mesh, or (no faces) a point cloud.
struct Shape {
  PointCloud cloud;
  Faces faces;
};

}  // namespace posture
