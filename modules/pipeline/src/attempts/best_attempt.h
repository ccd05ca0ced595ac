// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/pipeline/register_shapes.h>

#include "answer/attempt.h"
#include "stage_clock.h"
#include <functional>
#include <optional>
#include <vector>

namespace posture {

/// The same answer over more of both sides, paid for, or with the rest of the source laid as it
/// goes; nothing: it stays as it is.
using Extension = std::function<std::optional<RegistrationResult>(const RegistrationResult&)>;

/// Of several attempts at one pair, on different parts of it, the one that scores best, the first
/// if none is better by more than scores vary, finished; one that cannot be is left out, unless
/// it is the last. An answer found with a part is extended, and where it then fits worse than
/// another attempt, with the same answer or not, that one is taken. The best of those that lead
/// elsewhere is named among the alternatives; if the best one was extended and this is nearly as
/// good, it is finished, and extended, too, before. \pre  at least one.
/// \param extended  of what was found with a part of a side, which others may then agree with.
RegistrationResult bestAttempt(std::vector<Attempt> attempts,
                               const TriangleMesh& target,
                               const RegistrationOptions& options,
                               const Extension& extended,
                               StageClock& clock);

}  // namespace posture
