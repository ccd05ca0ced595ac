// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "attempts.h"
#include "given_shape.h"
#include "stage_clock.h"
#include <optional>

namespace posture {

/// Beyond the paper: spectra and canonical forms give candidates, those that keep the outside out
/// are bent onto the target, the best refined. That far the attempt goes at once; finishing it
/// takes the map to a fraction of an edge and completes the source. docs/pipeline.md has the
/// stages. The `input` of both sides and the clock outlive the attempt; `clean` need not.
/// \param known  an answer found otherwise, in the numbering of both inputs; null: none. Where it
/// is trusted and the best finalist agrees with it, none is changed any more, and of finalists
/// that are the same answer that one alone is refined.
Attempt refinedMethod(const GivenShape& source,
                      const GivenShape& target,
                      const RegistrationOptions& options,
                      StageClock& clock,
                      const RegistrationResult* known = nullptr);

/// The same, given up where the known answer stands (knownStands() in attempts.h): nothing then.
std::optional<Attempt> refinedMethodUnlessKnown(const GivenShape& source,
                                                const GivenShape& target,
                                                const RegistrationOptions& options,
                                                StageClock& clock,
                                                const RegistrationResult* known);

}  // namespace posture
