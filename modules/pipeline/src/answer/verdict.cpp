// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "answer/verdict.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace posture {
namespace {

/// Mean consistency of distances under the chosen candidate, below which two shapes are not taken
/// for one body: docs/decisions/published.md has the measurements it lies between.
constexpr double LEAST_CONSISTENCY = 0.855;

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

/// The answer most likely next to the chosen one; -1: there is none.
int rivalOf(const RegistrationResult& result) {
  int rival = -1;
  for (int k = 0; k < static_cast<int>(result.alternatives.size()); ++k)
    if (k != result.chosen && (rival < 0 || marginBefore(result, result.alternatives[k]) <
                                                marginBefore(result, result.alternatives[rival])))
      rival = k;
  return rival;
}

/// How likely it is that the better of two answers is the right one: even at a margin of 0.35, as
/// scores of one answer differ by that much between starts. Never 0: confidences are multiples of
/// the trust, and would be lost.
double decisionOf(double margin) {
  constexpr double LEAST = 1e-6;
  return 1 - std::exp(-2 * std::max(LEAST, margin));
}

/// With one decimal: a figure just below the limit must not read like it.
std::string percent(double share) {
  const long tenths = std::lround(1000 * share);
  return std::to_string(tenths / 10) + "." + std::to_string(tenths % 10) + " %";
}

}  // namespace

std::string mappedMessage(const RegistrationResult& result) {
  const long mapped = mappedCount(result.correspondence.on_target), all = presentCount(result);
  return std::to_string(mapped) + " of " + std::to_string(all) +
         (result.source_scan ? " source points" : " source vertices") + " have a counterpart (" +
         percent(static_cast<double>(mapped) / static_cast<double>(all)) + ")" +
         leftOutMessage(result);
}

std::string leftOutMessage(const RegistrationResult& result) {
  constexpr double LIKE_A_BODY = 0.5;
  const bool source = result.source.background_faces > 0,
             target = result.target.background_faces > 0;
  std::string message;
  if (source || target)
    message += std::string("; a floor or wall in the ") +
               (source && target ? "source and target"
                : source         ? "source"
                                 : "target") +
               " is left out";
  for (const auto& [side, summary] :
       {std::pair("source", &result.source), std::pair("target", &result.target)})
    if (summary->left_out_share > LIKE_A_BODY)
      message += std::string("; another part of the ") + side + ", " +
                 percent(summary->left_out_share) + " as large as the one registered, is left out";
  return message;
}

double likelihoodOf(const RegistrationResult& result, const AlternativeSummary& other) {
  return std::exp(std::min(0.0, -marginBefore(result, other)));
}

bool convinces(double score) { return score < EVEN_SCORE; }

bool isDecisive(double better, double worse) { return worse - better >= DECISIVE; }

bool mayConvince(double score) { return !isDecisive(EVEN_SCORE, score); }

bool looksAlike(const RegistrationResult& result) {
  return result.chosen >= 0 && convinces(result.score);
}

bool isDecided(const RegistrationResult& result) { return result.trust >= LEAST_TRUST; }

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
  giveVerdict(result);
}

void giveVerdict(RegistrationResult& result) {
  result.status = isDecided(result) ? Status::REGISTERED : Status::UNDECIDED;
  const int rival = rivalOf(result);
  const bool is_alike = likenessOf(result.score) >= LEAST_TRUST;
  if (result.status == Status::REGISTERED)
    result.message = mappedMessage(result);
  else if (!is_alike && likenessOf(result.score - result.hands) >= LEAST_TRUST)
    result.message =
        "the best map takes hands or feet to the mirror images of their like, as one that has "
        "front and back exchanged does: it is trusted to " +
        percent(result.trust) + " only";
  else if (!is_alike || rival < 0)
    result.message =
        "source and target do not look like one body in two poses: the best map between them is "
        "trusted to " +
        percent(result.trust) + " only";
  else
    result.message = "the data do not decide between answers that lie " +
                     percent(result.alternatives[rival].gap) +
                     " of the body's size (square root of its area) apart in the mean; the better "
                     "one is trusted to " +
                     percent(result.trust);
}

void giveVerdictWithoutFinalist(const Points& source, RegistrationResult& result) {
  result.correspondence.on_target.assign(source.rows(), {});
  result.correspondence.confidence = Vector::Zero(source.rows());
  result.deformed = result.scale * source;
  result.status = Status::UNDECIDED;
  result.message =
      "source and target do not look like one body in two poses: every map between them tears the "
      "surface or turns it inside out";
}

void givePublishedVerdict(RegistrationResult& result) {
  const HypothesisSummary& chosen = result.hypotheses[result.chosen];
  result.status = Status::UNDECIDED;
  if (chosen.accepted_vertices == 0) {
    result.message = "no candidate gives a consistent map from source to target";
  } else if (chosen.consistency < LEAST_CONSISTENCY) {
    result.message =
        "source and target do not look like one body in two poses: distances on them "
        "agree to only " +
        percent(chosen.consistency) + " under the best candidate (" + percent(LEAST_CONSISTENCY) +
        " at least is expected)";
  } else {
    result.status = Status::REGISTERED;
    result.message = mappedMessage(result);
  }
}

}  // namespace posture
