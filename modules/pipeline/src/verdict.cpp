// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "verdict.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace posture {
namespace {

/// Mean consistency of distances under the chosen candidate, below which two shapes are not taken
/// for one body: docs/decisions.md has the measurements it lies between.
constexpr double LEAST_CONSISTENCY = 0.855;

/// With one decimal: a figure just below the limit must not read like it.
std::string percent(double share) {
  const long tenths = std::lround(1000 * share);
  return std::to_string(tenths / 10) + "." + std::to_string(tenths % 10) + " %";
}

/// How many of the source's vertices the correspondence maps.
std::string mappedMessage(const RegistrationResult& result) {
  const auto& places = result.correspondence.on_target;
  const auto mapped = std::count_if(
      places.begin(), places.end(), [](const SurfacePoint& p) { return p.vertex >= 0; });
  return std::to_string(mapped) + " of " + std::to_string(places.size()) +
         " source vertices have a counterpart (" +
         percent(static_cast<double>(mapped) / static_cast<double>(places.size())) + ")";
}

}  // namespace

double trustIn(const RegistrationResult& result) {
  const double margin = result.alternatives.size() > 1
                            ? result.alternatives[1].score - result.alternatives[0].score
                            : 4;
  return 1 / (1 + std::exp(result.score + 7)) * (1 - std::exp(-2 * margin));
}

void giveVerdict(RegistrationResult& result) {
  result.status = result.trust >= 0.5 ? Status::REGISTERED : Status::UNDECIDED;
  if (result.status == Status::REGISTERED)
    result.message = mappedMessage(result);
  else
    result.message = "source and target do not look like one body in two poses";
}

void giveVerdictWithoutFinalist(const GivenShape& source, RegistrationResult& result) {
  const auto n = source.input.vertices.rows();
  result.correspondence.on_target.assign(n, {});
  result.correspondence.confidence = Vector::Zero(n);
  result.deformed = result.scale * source.input.vertices;
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
