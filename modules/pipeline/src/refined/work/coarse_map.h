// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/pipeline/register_shapes.h>
#include <posture/refine/bent_pair.h>

#include "refined/work/posed_side.h"
#include "sides/given_shape.h"

namespace posture {

/// An answer as a map between the coarse meshes of both sides. Apart is what has no counterpart in
/// it on the target's main surface, and what of the target nothing comes to lie near.
/// \param known  in the numbering of both inputs, finished: the source is deformed.
/// \throws NoWayOn  nothing of the coarse source has a counterpart
BentPair coarseMapOf(const PosedSide& source,
                     const PosedSide& target,
                     const RegistrationResult& known);

/// The map of a coarse finalist in the numbering of the input.
std::vector<int> coarseToInput(const VertexMaps& maps,
                               const GivenShape& source,
                               const RefinedShape& source_shape,
                               const GivenShape& target,
                               const RefinedShape& target_shape);

}  // namespace posture
