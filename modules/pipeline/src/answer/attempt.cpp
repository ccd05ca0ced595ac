// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "answer/attempt.h"

#include <utility>

namespace posture {

RegistrationResult finished(Attempt attempt) {
  return attempt.finish ? attempt.finish() : std::move(attempt.found);
}

Attempt withChange(Attempt attempt, const std::function<void(RegistrationResult&)>& change) {
  change(attempt.found);
  if (attempt.finish)
    attempt.finish = [finish = std::move(attempt.finish), change] {
      RegistrationResult result = finish();
      change(result);
      return result;
    };
  return attempt;
}

}  // namespace posture
