// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/pipeline/register_shapes.h>

#include "refined/chosen_map.h"
#include "stage_clock.h"

namespace posture {

/// The stages from annealing on: takes the map chosen to all vertices, and the whole source with
/// it.
RegistrationResult finishMap(const ChosenMap& chosen,
                             const RegistrationOptions& options,
                             StageClock& clock);

}  // namespace posture
