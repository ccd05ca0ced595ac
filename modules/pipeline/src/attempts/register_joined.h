// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/pipeline/register_shapes.h>

#include "sides/given_shape.h"
#include "stage_clock.h"
#include <optional>

namespace posture {

/// Surfaces in pieces, joined where the gaps between them are narrow: they may tell more. Nothing
/// where none are joined, or where what is joined cannot be bent.
std::optional<RegistrationResult> registerJoined(const GivenShape& source,
                                                 const GivenShape& target,
                                                 const RegistrationOptions& options,
                                                 StageClock& clock);

}  // namespace posture
