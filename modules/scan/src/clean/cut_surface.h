// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "clean/delaunay.h"
#include "points/spacing.h"
#include <vector>

namespace posture {

/// A surface with points for its vertices.
struct PointSurface {
  TriangleMesh mesh;
  std::vector<int> point;  ///< of each vertex; -1: beside a point that has another vertex
};

/// The faces between inside and outside, manifold and oriented: where sheets touch in an edge or a
/// point, each has its own vertices there. Faces longer than the reach of their corners are left
/// out, and those nearly as long that make a handle: a bridge between two limbs.
PointSurface cutSurface(const Points& points,
                        const Tetrahedra& tetrahedra,
                        const std::vector<char>& inside,
                        const Spacing& spacing);

}  // namespace posture
