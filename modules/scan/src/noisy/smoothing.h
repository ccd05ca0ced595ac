// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "points/neighbors.h"
#include "points/oriented_points.h"
#include "points/spacing.h"

namespace posture {

/// Moves points along their normals onto the surface of their neighbours, in two passes. Exact on
/// circular arcs, where it does not shrink; sheets that face each other do not mix.
/// \param residual  relative one of estimateNormals().
void smooth(const NeighborTable& neighbors,
            const Spacing& spacing,
            double residual,
            OrientedPoints& oriented);

}  // namespace posture
