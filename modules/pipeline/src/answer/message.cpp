// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "answer/message.h"

#include "answer/verdict.h"
#include <cmath>
#include <utility>

namespace posture {
namespace {

/// With one decimal, rounded down: a figure just below a limit, or all, must not read like it.
std::string percent(double share) {
  constexpr double ROUNDING = 1e-9;
  const long tenths = static_cast<long>(std::floor(1000 * share + ROUNDING));
  return std::to_string(tenths / 10) + "." + std::to_string(tenths % 10) + " %";
}

/// How many of the source's vertices, or points that are there, have a counterpart.
std::string howMuchIsMapped(const RegistrationResult& result) {
  const long mapped = mappedCount(result.correspondence.on_target), all = presentCount(result);
  return std::to_string(mapped) + " of " + std::to_string(all) +
         (result.source_scan ? " source points" : " source vertices") + " have a counterpart (" +
         percent(mappedShare(result)) + ")";
}

std::string whyNotAsPublished(const HypothesisSummary& chosen) {
  if (chosen.accepted_vertices == 0)
    return "no candidate gives a consistent map from source to target";
  return "source and target do not look like one body in two poses: distances on them agree to "
         "only " +
         percent(chosen.consistency) + " under the best candidate (" + percent(LEAST_CONSISTENCY) +
         " at least is expected)";
}

std::string whyNot(const RegistrationResult& result) {
  if (!result.hypotheses.empty()) return whyNotAsPublished(result.hypotheses[result.chosen]);
  if (result.chosen < 0)
    return "source and target do not look like one body in two poses: every map between them tears "
           "the surface or turns it inside out";
  const int rival = rivalOf(result);
  const bool is_alike = looksAlike(result);
  if (!is_alike && convinces(result.score - result.hands))
    return "the best map takes hands or feet to the mirror images of their like, as one that has "
           "front and back exchanged does: it is trusted to " +
           percent(result.trust) + " only";
  if (!is_alike || rival < 0)
    return "source and target do not look like one body in two poses: the best map between them is "
           "trusted to " +
           percent(result.trust) + " only";
  return "the data do not decide between answers that lie " +
         percent(result.alternatives[rival].gap) +
         " of the body's size (square root of its area) apart in the mean; the better one is "
         "trusted to " +
         percent(result.trust);
}

/// Begins with a semicolon; empty: nothing large was.
std::string whatIsLeftOut(const RegistrationResult& result) {
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

}  // namespace

std::string messageOf(const RegistrationResult& result) {
  return (result.status == Status::REGISTERED ? howMuchIsMapped(result) : whyNot(result)) +
         whatIsLeftOut(result);
}

}  // namespace posture
