// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/pipeline/register_shapes.h>

#include "sides/given_shape.h"
#include "sides/patched_shape.h"

namespace posture {

/// Takes the patches out of a result: their vertices have no row, and what lies on one, farther
/// from its rim than an edge and than maps are off, has no counterpart.
///
/// \param source, target  as they came, without patches.
void leaveOutPatches(const GivenShape& source,
                     const PatchedShape& source_patched,
                     const GivenShape& target,
                     const PatchedShape& target_patched,
                     RegistrationResult& result);

}  // namespace posture
