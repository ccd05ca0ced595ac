// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "given_shape.h"
#include "stage_clock.h"

namespace posture {

/// Beyond the paper: canonical forms give candidates, functional maps refine them, the least
/// strained one that keeps the outside out is bent onto the target in space.
RegistrationResult refinedMethod(const GivenShape& source,
                                 const GivenShape& target,
                                 const RegistrationOptions& options,
                                 StageClock& clock);

}  // namespace posture
