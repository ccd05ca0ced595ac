// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "points/in_line.h"

#include "points/local_plane.h"
#include <algorithm>

namespace posture {

bool isInLine(const Points& points, const NeighborTable& neighbors, int i) {
  const int count = std::min(16, neighborCount(neighbors, i));
  if (count == 0) return true;
  LocalPlane plane;
  plane.add(Eigen::Vector3d::Zero(), 1);
  for (int k = 0; k < count; ++k)
    plane.add((points.row(neighbors(i, k)) - points.row(i)).transpose(), 1);
  constexpr double NARROW = 0.05;  // at the end of a plane's corner 0.2 and more
  return plane.fit().breadth <
         NARROW * (points.row(neighbors(i, count - 1)) - points.row(i)).norm();
}

}  // namespace posture
