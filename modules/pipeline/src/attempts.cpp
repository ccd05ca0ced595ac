// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "attempts.h"

#include <posture/mesh/position_of.h>
#include <posture/refine/map_score.h>

#include "given_shape.h"
#include "verdict.h"
#include <cmath>
#include <utility>

namespace posture {
namespace {

/// Answers that are closer in the mean, in square roots of the target's area, are one: about the
/// distance between samples.
constexpr double SAME_ANSWER = 0.1;

/// What closed holes may cost of the score: by so much less, a map is e times less likely to be
/// right. Scans, whose maps are better for it, lose up to 0.42; where slits had been closed
/// that lead across a face, maps that were astray had lost 1.2 and more.
constexpr double COST_OF_PATCHES = 1;

/// Mean distance between where two answers take what both map; all of the size where they share
/// less than half.
double gapBetween(const RegistrationResult& x,
                  const RegistrationResult& y,
                  const TriangleMesh& target,
                  double size) {
  const std::vector<SurfacePoint>&a = x.correspondence.on_target, &b = y.correspondence.on_target;
  double sum = 0;
  int both = 0, either = 0;
  for (std::size_t v = 0; v < a.size(); ++v) {
    either += a[v].vertex >= 0 || b[v].vertex >= 0;
    if (a[v].vertex < 0 || b[v].vertex < 0) continue;
    ++both;
    sum += (positionOf(target, a[v]) - positionOf(target, b[v])).norm();
  }
  return 2 * both < either || both == 0 ? 1 : sum / (both * size);
}

}  // namespace

bool isSameAnswer(const RegistrationResult& x,
                  const RegistrationResult& y,
                  const TriangleMesh& target) {
  return gapBetween(x, y, target, std::sqrt(x.target.area)) < SAME_ANSWER;
}

RegistrationResult withPatchedMap(RegistrationResult as_given, RegistrationResult patched) {
  if (patched.score > as_given.score + COST_OF_PATCHES) return as_given;
  if (patched.trust > as_given.trust) return patched;
  setTrust(as_given.trust, patched);
  as_given.correspondence = std::move(patched.correspondence);
  as_given.deformed = std::move(patched.deformed);
  as_given.back = std::move(patched.back);
  as_given.scale = patched.scale;
  as_given.source.patched_holes = patched.source.patched_holes;
  as_given.target.patched_holes = patched.target.patched_holes;
  giveVerdict(as_given);
  return as_given;
}

RegistrationResult bestAttempt(std::vector<RegistrationResult> attempts,
                               const TriangleMesh& target,
                               const RegistrationOptions& options) {
  const double size = std::sqrt(attempts.front().target.area);
  std::size_t best = 0;
  for (std::size_t i = 1; i < attempts.size(); ++i) {
    const double gain = attempts[best].score - attempts[i].score;
    if (attempts[i].chosen >= 0 &&
        (attempts[best].chosen < 0 || gain >= (best == 0 ? SCORE_NOISE : 0)))
      best = i;
  }
  RegistrationResult result = std::move(attempts[best]);
  const RegistrationResult* rival = nullptr;
  double gap = 0;
  for (std::size_t i = 0; i < attempts.size(); ++i) {
    if (i == best || attempts[i].chosen < 0) continue;
    if (rival != nullptr && rival->score <= attempts[i].score) continue;
    const double far = gapBetween(result, attempts[i], target, size);
    if (far < SAME_ANSWER) continue;
    rival = &attempts[i];
    gap = far;
  }
  if (rival == nullptr) return result;
  AlternativeSummary other = rival->alternatives[rival->chosen];
  other.gap = gap;
  if (options.refine_alternatives) other.correspondence = rival->correspondence;
  addRival(std::move(other), rival->trust, result);
  return result;
}

}  // namespace posture
