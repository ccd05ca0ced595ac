// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "answer/verdict.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace posture {
namespace {

/// What a map pays for the share of its hands that are on the other side, one more counted as
/// right: 3.5 where one tells, 5.6 where four do, so that a half-turned body, which scores -10.4 to
/// -14, is not believed; 1.4 for one against three.
constexpr double COST_OF_HANDS = 7;

/// How fast likeness turns around EVEN_SCORE.
constexpr double SCORE_WIDTH = 0.3;

/// Below it the answer is called undecided.
constexpr double LEAST_TRUST = 0.5;

/// How likely it is, by its score alone, that a map is between poses of one body.
double likenessOf(double score) { return 1 / (1 + std::exp((score - EVEN_SCORE) / SCORE_WIDTH)); }

/// By how much the chosen answer scores better than another one: by the refined scores where both
/// have one, else by how much the best of all scores better than the other before refinement.
double marginBefore(const RegistrationResult& result, const AlternativeSummary& other) {
  const std::vector<AlternativeSummary>& all = result.alternatives;
  const AlternativeSummary& chosen = all[result.chosen];
  if (other.refined_score && chosen.refined_score)
    return *other.refined_score - *chosen.refined_score;
  // Refinement tells more than the scores before it, by which another may have been the best.
  const auto best = std::min_element(
      all.begin(), all.end(), [](const auto& x, const auto& y) { return x.score < y.score; });
  return other.score - best->score;
}

/// How likely it is that the better of two answers is the right one: even at a margin of 0.35, as
/// scores of one answer differ by that much between starts. Never 0: confidences are multiples of
/// the trust, and would be lost.
double decisionOf(double margin) {
  constexpr double LEAST = 1e-6;
  return 1 - std::exp(-2 * std::max(LEAST, margin));
}

}  // namespace

int rivalOf(const RegistrationResult& result) {
  int rival = -1;
  for (int k = 0; k < static_cast<int>(result.alternatives.size()); ++k)
    if (k != result.chosen && (rival < 0 || marginBefore(result, result.alternatives[k]) <
                                                marginBefore(result, result.alternatives[rival])))
      rival = k;
  return rival;
}

double likelihoodOf(const RegistrationResult& result, const AlternativeSummary& other) {
  return std::exp(std::min(0.0, -marginBefore(result, other)));
}

double costOfHands(double right, double wrong) {
  return COST_OF_HANDS * wrong / (right + wrong + 1);
}

bool mostHandsAreWrong(double cost) { return 2 * cost >= COST_OF_HANDS; }

bool convinces(double score) { return score < EVEN_SCORE; }

bool isDecisive(double better, double worse) { return worse - better >= DECISIVE; }

bool mayConvince(double score) { return !isDecisive(EVEN_SCORE, score); }

bool looksAlike(const RegistrationResult& result) {
  return result.chosen >= 0 && convinces(result.score);
}

double trustIn(double score, double margin) { return likenessOf(score) * decisionOf(margin); }

double trustIn(const RegistrationResult& result) {
  const int rival = rivalOf(result);
  return trustIn(result.score,
                 rival < 0 ? std::numeric_limits<double>::infinity()
                           : marginBefore(result, result.alternatives[rival]));
}

void setTrust(double trust, RegistrationResult& result) {
  // What was not trusted at all has no confidence to change.
  const double change = result.trust > 0 ? trust / result.trust : 0;
  result.trust = trust;
  result.status = trust >= LEAST_TRUST ? Status::REGISTERED : Status::UNDECIDED;
  result.correspondence.confidence *= change;
  if (result.back) result.back->correspondence.confidence *= change;
  for (AlternativeSummary& other : result.alternatives) other.correspondence.confidence *= change;
}

void addRival(AlternativeSummary rival, double rival_trust, RegistrationResult& result) {
  std::vector<AlternativeSummary>& all = result.alternatives;
  const auto worse = std::find_if(
      all.begin(), all.end(), [&](const auto& known) { return known.score > rival.score; });
  const auto at = worse - all.begin();
  if (at <= result.chosen) ++result.chosen;
  Correspondence map = std::move(rival.correspondence);
  rival.correspondence = {};
  all.insert(worse, std::move(rival));
  setTrust(std::min(result.trust, trustIn(result)), result);
  AlternativeSummary& added = all[static_cast<std::size_t>(at)];
  if (rival_trust > 0) map.confidence *= result.trust * likelihoodOf(result, added) / rival_trust;
  added.correspondence = std::move(map);
}

void leaveWhereItIs(const Points& source, RegistrationResult& result) {
  result.correspondence.on_target.assign(source.rows(), {});
  result.correspondence.confidence = Vector::Zero(source.rows());
  result.deformed = result.scale * source;
  result.status = Status::UNDECIDED;
}

void givePublishedVerdict(RegistrationResult& result) {
  const HypothesisSummary& chosen = result.hypotheses[result.chosen];
  result.status = chosen.accepted_vertices > 0 && chosen.consistency >= LEAST_CONSISTENCY
                      ? Status::REGISTERED
                      : Status::UNDECIDED;
}

}  // namespace posture
