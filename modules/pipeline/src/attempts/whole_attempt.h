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
#include <optional>

namespace posture {

/// Of an attempt at surfaces as they are and one at the same cut open: the better map tells, the
/// first ones already where they decide. The one cut open has to score better by more than scores
/// vary, and gives way to the other where it cannot be finished.
/// \param whole, cut  begun. \param known  see BegunAttempt::goOn.
///
/// \throws std::runtime_error  neither surface can be bent
Attempt betterOf(const BegunAttempt& whole,
                 const BegunAttempt& cut,
                 const RegistrationResult* known,
                 StageClock& clock);

/// Registers the shapes as they are and, where a surface may be grown together with itself, parted.
/// \param known  see BegunAttempt::goOn.
/// \return  nothing where there is no contact and the known answer stands.
/// \throws std::runtime_error  a surface cannot be bent, as given nor parted
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

/// The same with holes closed, on surfaces as they are and on those cut open, which are other
/// holes; patches are left out of its results.
/// \param whole, cut  `cut`: none where there is no contact. Both outlive the attempt.
/// \throws std::runtime_error  no surface can be bent
Attempt patchedAttempt(const GivenShape& source,
                       const GivenShape& target,
                       const PatchedSides& whole,
                       const std::optional<PatchedSides>& cut,
                       const RegistrationOptions& options,
                       StageClock& clock);

}  // namespace posture
