// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/point_cloud.h>

#include <vector>

namespace posture {

/// A frame and a unit of length of a scan's own: the origin in the middle of the points, the axes
/// those of their second moments. Far outliers move it hardly.
struct ScanFrame {
  Eigen::RowVector3d center = Eigen::RowVector3d::Zero();
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  ///< columns; a rotation
  double unit = 1;  ///< median distance of the points from the centre

  Points toWorking(const Points& points) const;
  Points toCloud(const Points& points) const;
};

/// The different finite points of a cloud in its own frame, rounded to a grid far below any noise
/// and sorted along a space-filling curve: near points are near in memory, and how the scan was
/// turned, moved, scaled and ordered is forgotten.
struct DistinctPoints {
  ScanFrame frame;
  Points points;           ///< m x 3
  std::vector<int> input;  ///< m: the first row of the cloud at this place
  std::vector<int> place;  ///< row of the cloud -> its point here; -1: not finite, or far off
  int missing = 0;         ///< rows that are not finite
  int far = 0;             ///< different ones a billion times the body's size away
  int repeated = 0;        ///< finite rows at the place of another, to the grid
};

/// \throws InputError  no finite point, all at one place, fewer than 32 different ones.
DistinctPoints distinctPoints(const Points& points);

}  // namespace posture
