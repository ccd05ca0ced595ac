// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "refined/refinement/full_resolution.h"
#include "refined/refinement/refined_maps.h"
#include "refined/work/refined_shape.h"
#include "sides/given_shape.h"

namespace posture {

/// n, in (0, 1]: whether the way there and back ends where it began.
Vector roundTripConfidence(const TriangleMesh& source, const VertexMaps& maps);

/// A full map in terms of the vertices and faces as they were given.
/// \param trust  in the whole map: each point is trusted so much at most.
Correspondence correspondenceOf(const GivenShape& source,
                                const RefinedShape& source_shape,
                                const GivenShape& target,
                                const RefinedShape& target_shape,
                                const FullMap& map,
                                double trust);

/// A map of the work meshes in terms of the vertices as they were given, to the spacing of these
/// meshes and for the main surface alone: enough to tell answers apart. Trusted fully.
Correspondence roughCorrespondenceOf(const GivenShape& source,
                                     const RefinedShape& source_shape,
                                     const GivenShape& target,
                                     const RefinedShape& target_shape,
                                     const RefinedMap& map);

}  // namespace posture
