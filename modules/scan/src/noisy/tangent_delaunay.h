// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "points/neighbors.h"
#include "points/oriented_points.h"
#include "points/spacing.h"
#include <array>
#include <vector>

namespace posture {

/// A triangle, counter-clockwise seen from outside, its lowest corner first.
struct TangentTriangle {
  std::array<int, 3> corners;
  int votes;  ///< corners in whose tangent plane it is Delaunay: 2 or 3
};

/// Triangles that at least two of their three corners see as Delaunay in their tangent planes
/// (Gopi, Krishnan and Silva 2000; Adamy, Giesen and John 2002), by corners. Edges longer than 1.5
/// spacings whose ends look at each other across a concave gap are refused as a likely contact of
/// two parts; no real crease is as long.
std::vector<TangentTriangle> tangentDelaunay(const OrientedPoints& oriented,
                                             const NeighborSearch& search,
                                             const NeighborTable& neighbors,
                                             const Spacing& spacing);

}  // namespace posture
