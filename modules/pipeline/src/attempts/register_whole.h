// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/pipeline/register_shapes.h>

#include "sides/given_shape.h"
#include "stage_clock.h"

namespace posture {

/// The main surfaces: as they are and, where there are holes to speak of, first with those closed
/// that may be; with contacts cut open where there are any.
/// \throws TornSurface, NoWayOn  no surface can be bent onto the other
RegistrationResult registerWhole(const GivenShape& source,
                                 const GivenShape& target,
                                 const RegistrationOptions& options,
                                 StageClock& clock);

}  // namespace posture
