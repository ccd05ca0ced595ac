// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sides/given_shape.h"
#include "stage_clock.h"

namespace posture {

/// Wuhrer, Shu and Bose 2009, sections 4 and 5.
RegistrationResult publishedMethod(const GivenShape& source,
                                   const GivenShape& target,
                                   StageClock& clock);

}  // namespace posture
