// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/point_cloud.h>

#include <vector>

namespace posture {

/// Centre and scale in which a scan is worked on: single precision suffices there.
struct WorkingFrame {
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  double unit = 1;  ///< a power of two: scaling changes no digit

  Points toWorking(const Points& points) const;
  Points toCloud(const Points& points) const;
};

/// The different finite points of a cloud in its working frame. They are sorted along a
/// space-filling curve: near points are near in memory, and the order in which they were given
/// is forgotten.
struct DistinctPoints {
  WorkingFrame frame;
  Points points;           ///< m x 3
  std::vector<int> input;  ///< m: the first row of the cloud at this place
  std::vector<int> place;  ///< row of the cloud -> its point here; -1: not finite
  int missing = 0;         ///< rows that are not finite
  int repeated = 0;        ///< finite rows at the place of another
};

/// \throws InputError  no finite point, all at one place, fewer than 32 different ones.
DistinctPoints distinctPoints(const Points& points);

}  // namespace posture
