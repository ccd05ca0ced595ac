// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "verdict.h"

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

}  // namespace

void giveVerdict(RegistrationResult& result) {
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
    int mapped = 0;
    for (int t : chosen.target_vertex) mapped += t >= 0;
    const auto total = chosen.target_vertex.size();
    result.status = Status::REGISTERED;
    result.message = std::to_string(mapped) + " of " + std::to_string(total) +
                     " source vertices have a counterpart (" +
                     percent(static_cast<double>(mapped) / static_cast<double>(total)) + ")";
  }
}

}  // namespace posture
