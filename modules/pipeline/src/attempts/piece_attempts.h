// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/pipeline/register_shapes.h>

#include "answer/attempt.h"
#include "sides/given_shape.h"
#include "stage_clock.h"
#include <optional>
#include <vector>

namespace posture {

/// For shapes of which no answer is all but certain: one may be a piece of the other. It is then
/// registered with the parts of that one it resembles, begun with all of them; the best goes on,
/// and others until one convinces whose first map was decisively better than theirs.
/// \pre  there is an attempt already, at all of both shapes.
void addPieceAttempts(const GivenShape& source,
                      const GivenShape& target,
                      const RegistrationOptions& options,
                      StageClock& clock,
                      std::vector<Attempt>& attempts);

/// For an answer found with a part of a side: the same over all of it that lies on the other side,
/// trusted as the part is, or less if it fits worse there. Where it does not go on, the rest of the
/// source lies as the part goes. \return  nothing: it was found with all there is.
std::optional<RegistrationResult> extendedToWhole(const GivenShape& source,
                                                  const GivenShape& target,
                                                  RegistrationResult known,
                                                  const RegistrationOptions& options,
                                                  StageClock& clock);

}  // namespace posture
