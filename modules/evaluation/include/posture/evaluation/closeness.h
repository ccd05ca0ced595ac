// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/types.h>

namespace posture {

/// How two sets of points lie on each other, meshes and clouds alike.
struct Closeness {
  double mean_distance = 0;  ///< of a moved point from the nearest target point, over the diagonal
                             ///< of the box of the middle 98 % of the target along each axis
  double moved_near = 0;     ///< share of the moved points within one spacing of a target point
  double target_near = 0;    ///< share of the target points within one spacing of a moved point
};

/// The spacing is that of the target's points: the side of the square each one stands for on its
/// surface, from the radius that holds 16 neighbours, the median over the points. Rows that are not
/// finite are left out. \throws std::invalid_argument  a side has no point.
Closeness measureCloseness(const Points& moved, const Points& target);

}  // namespace posture
