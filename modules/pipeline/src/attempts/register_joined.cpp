// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "attempts/register_joined.h"

#include "answer/attempt.h"
#include "attempts/leave_out_patches.h"
#include "refined/refined_method.h"
#include "sides/patched_shape.h"
#include <utility>

namespace posture {

std::optional<RegistrationResult> registerJoined(const GivenShape& source,
                                                 const GivenShape& target,
                                                 const RegistrationOptions& options,
                                                 StageClock& clock) {
  const auto [source_joined, target_joined] = clock.stage("joining", 0, [&] {
    return std::pair(withBridges(source.input, source.clean),
                     withBridges(target.input, target.clean));
  });
  if (source_joined.joined_pieces == 0 && target_joined.joined_pieces == 0) return {};
  std::optional<RegistrationResult> joined =
      clock.tryAttempt("joined", 0, [&, &a = source_joined, &b = target_joined] {
        return finished(refinedMethod(a.given(), b.given(), options, clock));
      });
  if (joined) leaveOutPatches(source, source_joined, target, target_joined, *joined);
  return joined;
}

}  // namespace posture
