// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/pipeline/register_shapes.h>

#include "answer/attempt.h"
#include "sides/contacts.h"
#include "sides/given_shape.h"
#include "stage_clock.h"
#include <optional>

namespace posture {

/// Registers the shapes as they are and, where a surface may be grown together with itself, parted:
/// the better map tells, the first ones already where they decide.
/// \param known  see BegunAttempt::goOn.
/// \return  nothing where there is no contact and the known answer stands.
/// \throws std::runtime_error  a surface cannot be bent, as given nor parted
std::optional<Attempt> wholeAttempt(const GivenShape& source,
                                    const GivenShape& target,
                                    const PartedSides& parted,
                                    const RegistrationOptions& options,
                                    const RegistrationResult* known,
                                    StageClock& clock);

}  // namespace posture
