// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "given_shape.h"
#include "stage_clock.h"

namespace posture {

/// Beyond the paper: spectra and canonical forms give candidates, those that keep the outside out
/// are bent onto the target, the best refined to a fraction of an edge, the whole source completed.
/// docs/pipeline.md has the stages.
RegistrationResult refinedMethod(const GivenShape& source,
                                 const GivenShape& target,
                                 const RegistrationOptions& options,
                                 StageClock& clock);

}  // namespace posture
