// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "clean/delaunay.h"
#include "points/spacing.h"
#include <array>
#include <vector>

namespace posture {

/// A surface with points for its vertices.
struct PointSurface {
  TriangleMesh mesh;
  std::vector<int> point;  ///< of each vertex; -1: beside a point that has another vertex
};

/// Whether a face looks away from where each of its corners was seen from.
/// \param to_eye  n x 3: the way from each point to there, or another that the surface looks along,
/// zero where unknown; 0 x 3: none is known.
bool looksAway(const std::array<int, 3>& face, const Points& points, const Points& to_eye);

/// The faces between inside and outside, manifold and oriented: where sheets touch in an edge or a
/// point, each has its own vertices there. Faces longer than the reach of their corners are left
/// out, and those nearly as long that make a handle: a bridge between two limbs. So are those that
/// look away from the sensor: tetrahedra have a back where points of one side have none.
PointSurface boundaryOfInside(const Points& points,
                              const Tetrahedra& tetrahedra,
                              const std::vector<char>& inside,
                              const Spacing& spacing,
                              const Points& to_eye);

}  // namespace posture
