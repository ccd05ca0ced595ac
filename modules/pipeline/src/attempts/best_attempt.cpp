// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "attempts/best_attempt.h"

#include <posture/refine/map_score.h>

#include "answer/same_answer.h"
#include "answer/shared_verdict.h"
#include "answer/verdict.h"
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

namespace posture {
namespace {

/// The one of least score, the first if none is better by more than scores vary.
std::size_t bestOf(const std::vector<Attempt>& attempts) {
  std::size_t best = 0;
  for (std::size_t i = 1; i < attempts.size(); ++i) {
    const RegistrationResult &known = attempts[best].found, &other = attempts[i].found;
    if (other.chosen >= 0 &&
        (known.chosen < 0 || known.score - other.score >= (best == 0 ? SCORE_NOISE : 0)))
      best = i;
  }
  return best;
}

struct Rival {
  const Attempt* attempt = nullptr;  // null: there is none
  double gap = 0;
};

/// Of the attempts that lead elsewhere than the best one, that of least score.
/// \param maps  of the best one, found and extended: what agrees with either is no rival.
Rival rivalOf(const std::vector<Attempt>& attempts,
              std::size_t best,
              const std::vector<const RegistrationResult*>& maps,
              const TriangleMesh& target,
              double size) {
  Rival rival;
  for (std::size_t i = 0; i < attempts.size(); ++i) {
    const RegistrationResult& found = attempts[i].found;
    if (i == best || found.chosen < 0) continue;
    if (rival.attempt != nullptr && rival.attempt->found.score <= found.score) continue;
    double gap = 0;
    const bool elsewhere =
        std::all_of(maps.begin(), maps.end(), [&](const RegistrationResult* map) {
          const Overlap overlap = overlapOf(*map, found, target, size);
          gap = gapOf(overlap);
          return leadsElsewhere(overlap);
        });
    if (elsewhere) rival = {&attempts[i], gap};
  }
  return rival;
}

/// What one attempt knows of the hands holds for all with the same answer.
void shareHands(const TriangleMesh& target, std::vector<Attempt>& attempts) {
  for (Attempt& attempt : attempts) {
    double hands = attempt.found.hands;
    for (const Attempt& other : attempts)
      hands = std::max(hands, handsByBoth(attempt.found, other.found, target));
    if (hands > attempt.found.hands)
      attempt = withChange(std::move(attempt),
                           [hands](RegistrationResult& result) { payForHands(hands, result); });
  }
}

/// The rival of an extended answer, extended as well if it may win or cost it much trust.
std::optional<RegistrationResult> extendedRival(const Rival& rival,
                                                double score,
                                                const Extension& extended,
                                                StageClock& clock) {
  const RegistrationResult& found = rival.attempt->found;
  const bool is_better = found.score < score;
  if (isDecisive(score, found.score) || !(looksAlike(found) || is_better)) return {};
  std::optional<RegistrationResult> whole = clock.tryTo([&] { return finished(*rival.attempt); });
  if (!whole) return {};
  std::optional<RegistrationResult> more = extended(*whole);
  return more ? more : whole;
}

}  // namespace

RegistrationResult bestAttempt(std::vector<Attempt> attempts,
                               const TriangleMesh& target,
                               const RegistrationOptions& options,
                               const Extension& extended,
                               StageClock& clock) {
  const double size = std::sqrt(attempts.front().found.target.area);
  shareHands(target, attempts);
  for (;;) {
    const std::size_t best = bestOf(attempts);
    Rival rival = rivalOf(attempts, best, {&attempts[best].found}, target, size);
    const auto finishBest = [&] { return finished(std::move(attempts[best])); };
    std::optional<RegistrationResult> result =
        attempts.size() == 1 ? finishBest() : clock.tryTo(finishBest);
    if (!result) {
      attempts.erase(attempts.begin() + static_cast<std::ptrdiff_t>(best));
      continue;
    }
    std::optional<RegistrationResult> other;
    if (std::optional<RegistrationResult> more = extended(*result)) {
      rival = rivalOf(attempts, best, {&*result, &*more}, target, size);
      result = std::move(more);
      if (rival.attempt != nullptr) other = extendedRival(rival, result->score, extended, clock);
      if (other && other->score < result->score - SCORE_NOISE) std::swap(*result, *other);
    }
    if (other) {  // they may agree now
      const Overlap overlap = overlapOf(*result, *other, target, size);
      if (!leadsElsewhere(overlap)) return std::move(*result);
      rival.gap = gapOf(overlap);
    }
    if (rival.attempt == nullptr) return std::move(*result);
    if (!other && options.refine_alternatives)
      other = clock.tryTo([&] { return finished(*rival.attempt); });
    const RegistrationResult& found = other ? *other : rival.attempt->found;
    AlternativeSummary summary = found.alternatives[found.chosen];
    summary.gap = rival.gap;
    if (options.refine_alternatives && other) summary.correspondence = other->correspondence;
    addRival(std::move(summary), found.trust, *result);
    return std::move(*result);
  }
}

}  // namespace posture
