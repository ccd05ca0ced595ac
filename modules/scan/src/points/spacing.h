// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "points/neighbors.h"
#include <algorithm>
#include <vector>

namespace posture {

/// Spacing h of points on a surface: each stands for an area of h^2, from the radius that holds 16
/// neighbours. The distance to the nearest neighbour would be far less where views overlap.
struct Spacing {
  std::vector<double> at;  ///< n: around each point, median over its neighbours
  double median = 0;       ///< over the points
};

/// How far a surface goes on from a point, in spacings: faces are not longer, and what is farther
/// from the surface is no part of it.
constexpr double SURFACE_REACH = 4;

/// How far the weights of neighbours reach: the sigma of their Gaussian.
inline double reach(double spacing) { return 1.2 * spacing; }

/// Distance from the surface, in spacings, that noise explains, where points lie `residual` from
/// the plane of their neighbours.
inline double noiseReach(double residual) { return std::max(1.5 * residual, 0.25); }

Spacing spacing(const Points& points, const NeighborTable& neighbors);

}  // namespace posture
