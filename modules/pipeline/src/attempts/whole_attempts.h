// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/pipeline/register_shapes.h>

#include "answer/attempt.h"
#include "refined/refined_method.h"
#include "sides/contacts.h"
#include "sides/given_shape.h"
#include "sides/patched_shape.h"
#include "stage_clock.h"
#include <functional>
#include <optional>

namespace posture {

/// Of an attempt at surfaces as they are and one at the same cut open: the better map tells, the
/// first ones already where they decide. The one cut open has to score better by more than scores
/// vary, and gives way to the other where it cannot be finished.
///
/// \param known  see KnownAnswer::result.
/// \throws TornSurface  neither surface can be bent
Attempt betterOf(const BegunAttempt& whole,
                 const BegunAttempt& cut,
                 const RegistrationResult* known,
                 StageClock& clock);

/// Registers the shapes as they are and, where a surface may be grown together with itself, parted.
/// \param known  see KnownAnswer::result.
/// \return  nothing where there is no contact and the known answer stands.
/// \throws TornSurface  a surface cannot be bent, as given nor parted
std::optional<Attempt> wholeAttempt(const GivenShape& source,
                                    const GivenShape& target,
                                    const PartedSides& parted,
                                    const RegistrationOptions& options,
                                    const RegistrationResult* known,
                                    StageClock& clock);

/// Both sides with holes closed.
struct PatchedSides {
  PatchedShape source, target;
};

/// Registers the shapes with holes closed, on surfaces that are cut open at contacts; where that
/// does not convince, also on those that are not, if they have holes to close, as a cut may be of
/// what is no contact. Patches are left out of its results.
///
/// \param uncut  makes these; empty where there is no contact. What it returns outlives the
/// attempt,
///               as `cut` does.
/// \throws TornSurface  no surface can be bent
Attempt patchedAttempt(const GivenShape& source,
                       const GivenShape& target,
                       const PatchedSides& cut,
                       const std::function<const PatchedSides&()>& uncut,
                       const RegistrationOptions& options,
                       StageClock& clock);

}  // namespace posture
