// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/pipeline/register_shapes.h>
#include <posture/refine/settle.h>

#include "posed_side.h"

namespace posture {

/// An answer as a map between the coarse meshes of both sides. Apart is what has no counterpart in
/// it on the target's main surface, and what of the target nothing comes to lie near.
/// \param known  in the numbering of both inputs, finished: the source is deformed.
/// \throws std::runtime_error  nothing of the coarse source has a counterpart
BentPair coarseMapOf(const PosedSide& source,
                     const PosedSide& target,
                     const RegistrationResult& known);

}  // namespace posture
