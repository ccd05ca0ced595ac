// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "points/neighbors.h"
#include "points/spacing.h"

namespace posture {

struct EstimatedNormals {
  Points normals;       ///< n x 3, unit, of any sign
  double residual = 0;  ///< median of the r.m.s. distance of 10 neighbours from their plane
  double relative_residual = 0;  ///< the same in spacings
};

/// Normals from the plane of the neighbours, in two passes that give less and less weight to what
/// is off the plane or turned away from it: opposing sheets and creases do not blur them.
EstimatedNormals estimateNormals(const Points& points,
                                 const NeighborTable& neighbors,
                                 const Spacing& spacing);

}  // namespace posture
