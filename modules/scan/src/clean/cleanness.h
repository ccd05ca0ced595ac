// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "points/neighbors.h"
#include "points/spacing.h"

namespace posture {

/// How points scatter about the surface.
struct Cleanness {
  bool is_clean = false;  ///< faces may go through the points themselves
  double noise = 0;       ///< in spacings: at most this
};

/// From the distances of some points' neighbourhoods from the quadrics that fit them: noise sets
/// the same in all of them, while coarse limbs and creases, which no quadric fits, are not
/// everywhere.
Cleanness cleanness(const Points& points, const NeighborTable& neighbors, const Spacing& spacing);

}  // namespace posture
