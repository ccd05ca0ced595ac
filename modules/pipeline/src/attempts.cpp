// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "attempts.h"

#include <posture/mesh/position_of.h>
#include <posture/refine/map_score.h>

#include "given_shape.h"
#include "judge_by_ends.h"
#include "verdict.h"
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

namespace posture {
namespace {

/// Answers that are closer in the mean, in square roots of the target's area, are one: about the
/// distance between samples.
constexpr double SAME_ANSWER = 0.1;

/// A hand, the least part that is a matter of its own, is a fiftieth of a body.
constexpr double A_PART = 0.02;

/// What surface put in may cost of the score: by so much less, a map is e times less likely to be
/// right. Scans, whose maps are better for it, lose up to 0.42; where slits had been closed
/// that lead across a face, maps that were astray had lost 1.2 and more.
constexpr double COST_OF_ADDED = 1;

bool isAstray(double score_without, double score_with) {
  return score_with > score_without + COST_OF_ADDED;
}

/// Two answers, where both map something.
struct Overlap {
  int both = 0, either = 0, fewer = 0;  ///< vertices that both, either, and the one with fewer map
  double gap = 0;                       ///< mean distance between where both take what both map
};

Overlap overlapOf(const RegistrationResult& x,
                  const RegistrationResult& y,
                  const TriangleMesh& target,
                  double size) {
  const std::vector<SurfacePoint>&a = x.correspondence.on_target, &b = y.correspondence.on_target;
  Overlap overlap;
  double sum = 0;
  for (std::size_t v = 0; v < a.size(); ++v) {
    overlap.either += a[v].vertex >= 0 || b[v].vertex >= 0;
    if (a[v].vertex < 0 || b[v].vertex < 0) continue;
    ++overlap.both;
    sum += (positionOf(target, a[v]) - positionOf(target, b[v])).norm();
  }
  overlap.fewer = static_cast<int>(std::min(mappedCount(a), mappedCount(b)));
  if (overlap.both > 0) overlap.gap = sum / (overlap.both * size);
  return overlap;
}

/// How far two answers lie apart; 1 where they hardly map the same.
double gapOf(const Overlap& overlap) {
  return overlap.both == 0 || 2 * overlap.both < overlap.fewer ? 1 : overlap.gap;
}

/// One that maps less, and agrees there, does not lead elsewhere.
bool leadsElsewhere(const Overlap& overlap) { return gapOf(overlap) >= SAME_ANSWER; }

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

}  // namespace

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

bool isSameAnswer(const RegistrationResult& x,
                  const RegistrationResult& y,
                  const TriangleMesh& target) {
  const Overlap overlap = overlapOf(x, y, target, std::sqrt(x.target.area));
  return overlap.both > 0 && 2 * overlap.both >= overlap.either && overlap.gap < SAME_ANSWER;
}

bool goesOn(const RegistrationResult& known,
            const RegistrationResult& more,
            const TriangleMesh& target) {
  const auto before = static_cast<double>(mappedCount(known.correspondence.on_target)),
             after = static_cast<double>(mappedCount(more.correspondence.on_target));
  return after >= (1 - A_PART) * before &&
         !leadsElsewhere(overlapOf(known, more, target, std::sqrt(known.target.area)));
}

bool agreeEverywhere(const std::vector<SurfacePoint>& x,
                     const std::vector<SurfacePoint>& y,
                     const TriangleMesh& target,
                     double size) {
  int both = 0, either = 0, elsewhere = 0;
  for (std::size_t v = 0; v < x.size(); ++v) {
    either += x[v].vertex >= 0 || y[v].vertex >= 0;
    if (x[v].vertex < 0 || y[v].vertex < 0) continue;
    ++both;
    elsewhere += (positionOf(target, x[v]) - positionOf(target, y[v])).norm() > SAME_ANSWER * size;
  }
  return both > 0 && 2 * both >= either && elsewhere < A_PART * both;
}

double handsByBoth(const RegistrationResult& result,
                   const RegistrationResult& other,
                   const TriangleMesh& target) {
  return other.hands > result.hands && 2 * other.hands >= COST_OF_HANDS &&
                 !leadsElsewhere(overlapOf(result, other, target, std::sqrt(result.target.area)))
             ? other.hands
             : result.hands;
}

void payForHands(double hands, RegistrationResult& result) {
  if (result.chosen < 0 || !(hands > result.hands)) return;
  const double more = hands - result.hands;
  result.hands = hands;
  result.score += more;
  std::optional<double>& refined = result.alternatives[result.chosen].refined_score;
  if (refined) *refined += more;
  setTrust(trustIn(result), result);
  giveVerdict(result);
}

void payForExtending(double score, double hands, RegistrationResult& result) {
  const double more = score - result.score;
  if (result.chosen < 0 || !(more > 0)) return;
  result.score = score;
  result.hands = hands;
  for (AlternativeSummary& one : result.alternatives)
    if (one.refined_score) *one.refined_score += more;
  setTrust(std::min(result.trust, trustIn(result)), result);
  giveVerdict(result);
}

bool leadsAstray(const RegistrationResult& without, const RegistrationResult& with) {
  return isAstray(without.score - without.hands, with.score - with.hands);
}

bool knownStands(const RegistrationResult& known, double confirming_score) {
  return known.trust >= ALL_BUT_CERTAIN &&
         !isAstray(confirming_score, known.alternatives[known.chosen].score);
}

RegistrationResult withMapOf(RegistrationResult verdict, RegistrationResult map) {
  if (map.trust > verdict.trust) return map;
  setTrust(verdict.trust, map);
  verdict.correspondence = std::move(map.correspondence);
  verdict.deformed = std::move(map.deformed);
  verdict.back = std::move(map.back);
  verdict.scale = map.scale;
  verdict.source = withMeasured(std::move(verdict.source), map.source);
  verdict.target = withMeasured(std::move(verdict.target), map.target);
  giveVerdict(verdict);
  return verdict;
}

namespace {

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
