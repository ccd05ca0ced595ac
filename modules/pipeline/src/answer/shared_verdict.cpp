// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "answer/shared_verdict.h"

#include "answer/same_answer.h"
#include "answer/verdict.h"
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace posture {
namespace {

/// What surface put in may cost of the score: by so much less, a map is e times less likely to be
/// right. Scans, whose maps are better for it, lose up to 0.42; where slits had been closed
/// that lead across a face, maps that were astray had lost 1.2 and more.
constexpr double COST_OF_ADDED = 1;

bool isAstray(double score_without, double score_with) {
  return score_with > score_without + COST_OF_ADDED;
}

}  // namespace

double handsByBoth(const RegistrationResult& result,
                   const RegistrationResult& other,
                   const TriangleMesh& target) {
  return other.hands > result.hands && mostHandsAreWrong(other.hands) &&
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
}

void payForExtending(double score, double hands, RegistrationResult& result) {
  const double more = score - result.score;
  if (result.chosen < 0 || !(more > 0)) return;
  result.score = score;
  result.hands = hands;
  for (AlternativeSummary& one : result.alternatives)
    if (one.refined_score) *one.refined_score += more;
  setTrust(std::min(result.trust, trustIn(result)), result);
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
  verdict.source = withMeasured(verdict.source, map.source);
  verdict.target = withMeasured(verdict.target, map.target);
  return verdict;
}

ShapeSummary withMeasured(ShapeSummary whole, const ShapeSummary& compared) {
  whole.samples = compared.samples;
  whole.stress = compared.stress;
  whole.patched_holes = compared.patched_holes;
  whole.joined_pieces = compared.joined_pieces;
  whole.parted_contacts = compared.parted_contacts;
  whole.added_vertices = compared.added_vertices;
  return whole;
}

}  // namespace posture
