// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "answer/attempt.h"

#include <algorithm>
#include <utility>

namespace posture {

bool isOfPart(const RegistrationResult& result) {
  return std::min(result.source.compared_share, result.target.compared_share) < 1;
}

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
