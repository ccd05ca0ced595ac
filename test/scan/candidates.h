// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "noisy/tangent_delaunay.h"
#include <vector>

namespace posture::test {

/// In a plane z = const.
inline OrientedPoints upward(const Points& points) {
  OrientedPoints oriented{points, Points::Zero(points.rows(), 3)};
  oriented.normals.col(2).setOnes();
  return oriented;
}

inline std::vector<TangentTriangle> candidatesOf(const OrientedPoints& oriented) {
  const NeighborSearch search(oriented.points);
  const NeighborTable neighbors = search.table(32);
  return tangentDelaunay(oriented, search, neighbors, spacing(oriented.points, neighbors));
}

}  // namespace posture::test
