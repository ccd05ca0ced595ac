// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "error_json.h"

#include <posture/evaluation/statistics.h>

#include <algorithm>
#include <vector>

namespace posture::app {

Json toJson(const MapErrors& errors) {
  const auto x100 = [](double error) { return 100 * error; };
  const double share_accepted = errors.source_vertices > 0
                                    ? static_cast<double>(errors.accepted) / errors.source_vertices
                                    : 0.0;
  return {{"mean_x100", x100(mean(errors.relative_error))},
          {"median_x100", x100(percentile(errors.relative_error, 0.5))},
          {"percentile_95_x100", x100(percentile(errors.relative_error, 0.95))},
          {"mean_with_misses_x100", x100(meanWithMisses(errors))},
          {"source_vertices", errors.source_vertices},
          {"accepted", errors.accepted},
          {"rejected", errors.source_vertices - errors.accepted},
          {"share_accepted", share_accepted},
          {"true_pairs", errors.true_pairs},
          {"mapped_pairs", errors.mapped_pairs},
          {"measured_pairs", errors.relative_error.size()},
          {"share_within_two_edges", shareWithinTwoEdges(errors)},
          {"edge_histogram", edgeHistogram(errors)},
          {"curve", errorCurve(errors)}};
}

Json toJson(const MirrorComparison& comparison) {
  return {{"pairs", comparison.pairs},
          {"mean_to_truth_x100", 100 * comparison.mean_to_truth},
          {"mean_to_mirror_x100", 100 * comparison.mean_to_mirror},
          {"share_nearer_mirror", comparison.share_nearer_mirror},
          {"wrong_side", comparison.wrong_side}};
}

double curveAt(const Json& errors, double place) {
  const std::vector<double> places = curvePlaces();
  const auto found = std::lower_bound(places.begin(), places.end(), place - 1e-9);
  return errors["curve"][found - places.begin()];
}

}  // namespace posture::app
