// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "thinning.h"
#include <array>
#include <vector>

namespace posture {

/// Which edges are refused as a likely contact of two parts: those whose ends look at each other
/// across a concave gap.
enum class ContactGate {
  LONG_EDGES,  ///< where they are also longer than 1.5 spacings: no real crease is cut
  ALL_EDGES,   ///< cuts creases as well
};

/// A triangle, counter-clockwise seen from outside, its lowest corner first.
struct Candidate {
  std::array<int, 3> corners;
  int votes;  ///< corners in whose tangent plane it is Delaunay: 2 or 3
};

/// Triangles that at least two of their three corners see as Delaunay in their tangent planes
/// (Gopi, Krishnan and Silva 2000; Adamy, Giesen and John 2002), by corners.
std::vector<Candidate> tangentDelaunay(const OrientedPoints& oriented,
                                       const NeighborSearch& search,
                                       const NeighborTable& neighbors,
                                       const Spacing& spacing,
                                       ContactGate gate);

}  // namespace posture
