// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/pipeline/register_shapes.h>

#include "sides/leave_out_background.h"

namespace posture {

/// Vertices of the background have no counterpart, though they may have come to lie beside the
/// other surface, and are moved as a whole, as the body is in the mean.
/// \param at_rest  n x 3, the source's vertices.
void dropBackground(const Background& source,
                    const Points& at_rest,
                    const Background& target,
                    RegistrationResult& result);

}  // namespace posture
