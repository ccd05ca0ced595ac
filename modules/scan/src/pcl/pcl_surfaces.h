// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "points/neighbors.h"
#include "points/oriented_points.h"

namespace posture {

/// PCL's moving least squares: points moved onto local quadrics, with normals of any sign. A point
/// with too few neighbours stays.
OrientedPoints movingLeastSquares(const Points& points, double radius);

/// PCL's Poisson surface (Kazhdan, Bolitho and Hoppe 2006), cut back to the faces near a point
/// whose normal agrees and that does not lie in a line with its neighbours; its vertices are its
/// own.
TriangleMesh poissonSurface(const OrientedPoints& oriented,
                            const NeighborTable& neighbors,
                            double spacing);

/// PCL's greedy projection (Marton, Rusu and Beetz 2009); the vertices are the points.
TriangleMesh greedySurface(const OrientedPoints& oriented, double spacing);

}  // namespace posture
