// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "neighbors.h"
#include <vector>

namespace posture {

/// Median; the lower one of an even number. \pre  not empty.
double median(std::vector<double> values);

/// Spacing h of points on a surface: each stands for an area of h^2 (median over the points, from
/// the radius that holds 16 neighbours). The distance to the nearest neighbour would be far less
/// where views overlap.
double spacing(const Points& points, const NeighborTable& neighbors);

}  // namespace posture
