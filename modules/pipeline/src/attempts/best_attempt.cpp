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
#include <vector>

namespace posture {
namespace {

/// An attempt, finished and extended as far as it takes to know which is the best.
struct Contender {
  Attempt attempt;
  std::optional<RegistrationResult> whole;       ///< finished, and extended where it can be
  std::optional<RegistrationResult> unextended;  ///< finished, where it was extended

  const RegistrationResult& known() const { return whole ? *whole : attempt.found; }
};

/// Whether one that would be extended has the answer of one that was, and convinces: it would come
/// to the same.
bool isSpokenFor(const Contender& one,
                 const std::vector<Contender>& contenders,
                 const TriangleMesh& target,
                 double size) {
  const RegistrationResult& found = one.attempt.found;
  return !one.whole && isOfPart(found) &&
         std::any_of(contenders.begin(), contenders.end(), [&](const Contender& other) {
           return other.unextended && looksAlike(*other.whole) &&
                  !leadsElsewhere(overlapOf(*other.unextended, found, target, size));
         });
}

/// The one of least score, the first if none is better by more than scores vary.
std::size_t bestOf(const std::vector<Contender>& contenders,
                   const TriangleMesh& target,
                   double size) {
  std::size_t best = 0;
  for (std::size_t i = 1; i < contenders.size(); ++i) {
    if (isSpokenFor(contenders[i], contenders, target, size)) continue;
    const RegistrationResult &known = contenders[best].known(), &other = contenders[i].known();
    if (other.chosen >= 0 &&
        (known.chosen < 0 || known.score - other.score >= (best == 0 ? SCORE_NOISE : 0)))
      best = i;
  }
  return best;
}

struct Rival {
  std::optional<std::size_t> contender;  // none: there is none
  double gap = 0;
};

/// Of those that lead elsewhere than the best one, which is finished, that of least score. What
/// agrees with it before or after it was extended is no rival, and what is spoken for counts as
/// that.
Rival rivalOf(const std::vector<Contender>& contenders,
              std::size_t best,
              const TriangleMesh& target,
              double size) {
  std::vector<const RegistrationResult*> maps;
  if (contenders[best].unextended) maps.push_back(&*contenders[best].unextended);
  maps.push_back(&*contenders[best].whole);
  Rival rival;
  for (std::size_t i = 0; i < contenders.size(); ++i) {
    const RegistrationResult& known = contenders[i].known();
    if (i == best || known.chosen < 0 || isSpokenFor(contenders[i], contenders, target, size))
      continue;
    if (rival.contender && contenders[*rival.contender].known().score <= known.score) continue;
    double gap = 0;
    const bool elsewhere =
        std::all_of(maps.begin(), maps.end(), [&](const RegistrationResult* map) {
          const Overlap overlap = overlapOf(*map, known, target, size);
          gap = gapOf(overlap);
          return leadsElsewhere(overlap);
        });
    if (elsewhere) rival = {i, gap};
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

/// Whether an extended answer is to be compared with what a rival comes to when it is extended,
/// too: it may win, or cost much trust.
bool mayMatter(const RegistrationResult& extended, const RegistrationResult& rival) {
  return !isDecisive(extended.score, rival.score) &&
         (looksAlike(rival) || rival.score < extended.score);
}

/// The contenders, and the way to finish them.
class Contest {
 public:
  Contest(std::vector<Attempt> attempts, const Extension& extended, StageClock& clock)
      : extended_(extended), clock_(clock) {
    for (Attempt& attempt : attempts) contenders_.push_back({std::move(attempt), {}, {}});
  }

  std::vector<Contender>& contenders() { return contenders_; }

  /// Finishes and extends one; where it cannot be finished it gives way to the others.
  void take(std::size_t i) {
    Contender& one = contenders_[i];
    const auto finish = [&] { return finished(std::move(one.attempt)); };
    std::optional<RegistrationResult> result =
        contenders_.size() == 1 ? finish() : clock_.tryTo(finish);
    if (!result) {
      contenders_.erase(contenders_.begin() + static_cast<std::ptrdiff_t>(i));
      return;
    }
    one.whole = extended_(*result);
    (one.whole ? one.unextended : one.whole) = std::move(result);
  }

 private:
  std::vector<Contender> contenders_;
  const Extension& extended_;
  StageClock& clock_;
};

}  // namespace

RegistrationResult bestAttempt(std::vector<Attempt> attempts,
                               const TriangleMesh& target,
                               const RegistrationOptions& options,
                               const Extension& extended,
                               StageClock& clock) {
  const double size = std::sqrt(attempts.front().found.target.area);
  shareHands(target, attempts);
  Contest contest(std::move(attempts), extended, clock);
  std::vector<Contender>& contenders = contest.contenders();
  for (;;) {
    const std::size_t best = bestOf(contenders, target, size);
    if (!contenders[best].whole) {
      contest.take(best);
      continue;
    }
    RegistrationResult& result = *contenders[best].whole;
    const Rival rival = rivalOf(contenders, best, target, size);
    if (!rival.contender) return std::move(result);
    Contender& other = contenders[*rival.contender];
    if (!other.whole && contenders[best].unextended && mayMatter(result, other.attempt.found)) {
      contest.take(*rival.contender);
      continue;
    }
    AlternativeSummary summary = other.known().alternatives[other.known().chosen];
    summary.gap = rival.gap;
    // Ends of limbs are compared within an attempt alone: it is worse by what the score says.
    if (const auto& refined = result.alternatives[result.chosen].refined_score;
        refined && summary.refined_score)
      summary.refined_score = *refined + other.known().score - result.score;
    const double trust = other.known().trust;
    if (options.refine_alternatives) {
      if (!other.whole)
        other.whole = clock.tryTo([&] { return finished(std::move(other.attempt)); });
      if (other.whole) summary.correspondence = other.whole->correspondence;
    }
    addRival(std::move(summary), trust, result);
    return std::move(result);
  }
}

}  // namespace posture
