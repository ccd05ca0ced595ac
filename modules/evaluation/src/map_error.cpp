// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/error.h>
#include <posture/evaluation/map_error.h>
#include <posture/evaluation/statistics.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <unordered_map>

namespace posture {
namespace {

constexpr int SAMPLE_PAIRS = 1000;
constexpr double CURVE_STEP = 0.0025;
constexpr int CURVE_STEPS = 100;

void checkSource(const VertexPair& pair, std::size_t source_vertices) {
  require(pair.source >= 0 && static_cast<std::size_t>(pair.source) < source_vertices,
          "true pair of source vertex " + std::to_string(pair.source) + ", the map has " +
              std::to_string(source_vertices));
}

std::vector<Route> mappedRoutes(const std::vector<SurfacePoint>& on_target,
                                const std::vector<VertexPair>& truth) {
  std::vector<Route> routes;
  routes.reserve(truth.size());
  for (const VertexPair& pair : truth) {
    checkSource(pair, on_target.size());
    if (on_target[pair.source].vertex >= 0) routes.push_back({pair.target, on_target[pair.source]});
  }
  return routes;
}

std::vector<Route> evenRoutes(const std::vector<Route>& routes, int limit) {
  std::vector<Route> subset;
  for (int r : evenSubset(static_cast<int>(routes.size()), limit)) subset.push_back(routes[r]);
  return subset;
}

/// As many of the routes as `work` allows to measure.
std::vector<Route> affordableRoutes(const TargetMetric& target,
                                    const std::vector<Route>& routes,
                                    std::int64_t work) {
  const auto most = static_cast<std::int64_t>(routes.size()) * target.vertexCount();
  if (most <= work) return routes;
  const std::vector<Route> sample = evenRoutes(routes, SAMPLE_PAIRS);
  const double cost = static_cast<double>(target.geodesics(sample).settled_vertices) /
                      static_cast<double>(sample.size());
  const double affordable = std::max<double>(SAMPLE_PAIRS, static_cast<double>(work) / cost);
  if (affordable >= static_cast<double>(routes.size())) return routes;
  return evenRoutes(routes, static_cast<int>(affordable));
}

/// Lengths in units of the square root of the target's area.
std::vector<double> relativeLengths(const TargetMetric& target, const std::vector<Route>& routes) {
  std::vector<double> lengths = target.geodesics(routes).length;
  for (double& length : lengths) length /= target.rootArea();
  return lengths;
}

}  // namespace

MapErrors measureErrors(const TargetMetric& target,
                        const std::vector<SurfacePoint>& on_target,
                        const std::vector<VertexPair>& truth,
                        std::int64_t work) {
  MapErrors errors;
  errors.source_vertices = static_cast<int>(on_target.size());
  errors.accepted = static_cast<int>(mappedCount(on_target));
  const std::vector<Route> mapped = mappedRoutes(on_target, truth);
  errors.true_pairs = static_cast<int>(truth.size());
  errors.mapped_pairs = static_cast<int>(mapped.size());
  const std::vector<Route> measured = affordableRoutes(target, mapped, work);
  errors.relative_error = relativeLengths(target, measured);
  errors.edge_error = target.edgeCounts(measured);
  return errors;
}

std::vector<double> curvePlaces() {
  std::vector<double> places(CURVE_STEPS + 1);
  for (int i = 0; i <= CURVE_STEPS; ++i) places[i] = CURVE_STEP * i;
  return places;
}

std::vector<double> errorCurve(const MapErrors& errors) {
  std::vector<double> sorted = errors.relative_error;
  std::sort(sorted.begin(), sorted.end());
  const double share_mapped =
      errors.true_pairs > 0 ? static_cast<double>(errors.mapped_pairs) / errors.true_pairs : 0;
  std::vector<double> curve;
  curve.reserve(CURVE_STEPS + 1);
  for (double place : curvePlaces()) {
    const auto below = std::upper_bound(sorted.begin(), sorted.end(), place) - sorted.begin();
    curve.push_back(sorted.empty() ? 0 : share_mapped * static_cast<double>(below) / sorted.size());
  }
  return curve;
}

double meanWithMisses(const MapErrors& errors) {
  const double last = curvePlaces().back();
  std::vector<double> capped = errors.relative_error;
  for (double& error : capped) error = std::min(error, last);
  const double of_mapped = capped.empty() ? last : mean(capped);
  const double share_mapped = static_cast<double>(errors.mapped_pairs) / errors.true_pairs;
  return share_mapped * of_mapped + (1 - share_mapped) * last;
}

std::vector<int> edgeHistogram(const MapErrors& errors) {
  std::vector<int> histogram;
  for (int edges : errors.edge_error) {
    if (edges >= static_cast<int>(histogram.size())) histogram.resize(edges + 1, 0);
    ++histogram[edges];
  }
  return histogram;
}

double shareWithinTwoEdges(const MapErrors& errors) {
  if (errors.edge_error.empty()) return std::numeric_limits<double>::quiet_NaN();
  const auto within = std::count_if(
      errors.edge_error.begin(), errors.edge_error.end(), [](int edges) { return edges <= 2; });
  return static_cast<double>(within) / static_cast<double>(errors.edge_error.size());
}

std::vector<CandidateError> candidateErrors(const TargetMetric& target,
                                            const std::vector<std::vector<int>>& target_vertex,
                                            const std::vector<VertexPair>& truth,
                                            int pairs) {
  const std::vector<int> looked_at = evenSubset(static_cast<int>(truth.size()), pairs);
  std::vector<Route> routes;  // of all candidates, so that they share their fronts
  std::vector<int> candidate_of;
  for (std::size_t c = 0; c < target_vertex.size(); ++c)
    for (int p : looked_at) {
      checkSource(truth[p], target_vertex[c].size());
      const int found = target_vertex[c][truth[p].source];
      if (found < 0) continue;
      Route route;
      route.from = truth[p].target;
      route.to.vertex = found;
      routes.push_back(route);
      candidate_of.push_back(static_cast<int>(c));
    }
  const std::vector<double> lengths = relativeLengths(target, routes);
  std::vector<std::vector<double>> errors(target_vertex.size());
  for (std::size_t r = 0; r < routes.size(); ++r) errors[candidate_of[r]].push_back(lengths[r]);
  std::vector<CandidateError> result;
  result.reserve(errors.size());
  for (const auto& of_candidate : errors)
    result.push_back({mean(of_candidate),
                      looked_at.empty() ? 0.0
                                        : static_cast<double>(of_candidate.size()) /
                                              static_cast<double>(looked_at.size())});
  return result;
}

int bestCandidate(const std::vector<CandidateError>& candidates) {
  double most_mapped = 0;
  for (const CandidateError& c : candidates) most_mapped = std::max(most_mapped, c.share_mapped);
  int best = -1;
  for (std::size_t c = 0; c < candidates.size(); ++c) {
    if (candidates[c].share_mapped <= 0 || candidates[c].share_mapped < most_mapped / 4) continue;
    if (best < 0 || candidates[c].mean < candidates[best].mean) best = static_cast<int>(c);
  }
  return best;
}

bool choseWrong(const CandidateError& chosen, const CandidateError& best) {
  if (chosen.share_mapped <= 0) return best.share_mapped > 0;
  return chosen.mean > 1.5 * best.mean && chosen.mean > best.mean + 0.02;
}

MirrorComparison compareWithMirror(const TargetMetric& target,
                                   const std::vector<SurfacePoint>& on_target,
                                   const std::vector<VertexPair>& truth,
                                   const std::vector<VertexPair>& mirror_truth,
                                   int pairs) {
  std::unordered_map<int, int> mirror_of;
  for (const VertexPair& pair : mirror_truth) mirror_of.try_emplace(pair.source, pair.target);
  std::vector<VertexPair> common_truth, common_mirror;
  for (const VertexPair& pair : truth) {
    checkSource(pair, on_target.size());
    const auto mirrored = mirror_of.find(pair.source);
    if (mirrored == mirror_of.end() || on_target[pair.source].vertex < 0) continue;
    common_truth.push_back(pair);
    common_mirror.push_back({pair.source, mirrored->second});
  }
  const auto errors_to = [&](const std::vector<VertexPair>& answer) {
    return relativeLengths(target, evenRoutes(mappedRoutes(on_target, answer), pairs));
  };
  const std::vector<double> to_truth = errors_to(common_truth);
  const std::vector<double> to_mirror = errors_to(common_mirror);
  MirrorComparison result;
  result.pairs = static_cast<int>(to_truth.size());
  result.mean_to_truth = mean(to_truth);
  result.mean_to_mirror = mean(to_mirror);
  int nearer_mirror = 0;
  for (std::size_t i = 0; i < to_truth.size(); ++i) nearer_mirror += to_mirror[i] < to_truth[i];
  result.share_nearer_mirror =
      to_truth.empty() ? 0 : static_cast<double>(nearer_mirror) / static_cast<double>(result.pairs);
  result.wrong_side = result.mean_to_mirror < result.mean_to_truth;
  return result;
}

}  // namespace posture
