// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "benchmark_pair.h"

#include <posture/core/error.h>
#include <posture/evaluation/statistics.h>
#include <posture/evaluation/surface_fit.h>
#include <posture/evaluation/truth.h>
#include <posture/io/mesh_io.h>
#include <posture/pipeline/register_shapes.h>
#include <posture/report/peak_memory.h>

#include <algorithm>
#include <chrono>
#include <omp.h>
#include <utility>

namespace posture::app {
namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

struct PairData {
  TriangleMesh source, target;
  std::vector<VertexPair> truth, mirror_truth;  // empty: not known
};

/// Also the seconds that reading the two meshes took.
std::pair<PairData, double> readPair(const BenchmarkPair& pair) {
  PairData data;
  const auto start = Clock::now();
  data.source = readMesh(pair.source).mesh;
  data.target = readMesh(pair.target).mesh;
  const double seconds = secondsSince(start);
  const int n = static_cast<int>(data.source.vertices.rows());
  const int m = static_cast<int>(data.target.vertices.rows());
  if (!pair.truth.empty()) data.truth = readTruth(pair.truth, n, m);
  if (!pair.mirror_truth.empty()) data.mirror_truth = readTruth(pair.mirror_truth, n, m);
  return {std::move(data), seconds};
}

/// The answers that the method chose among.
std::vector<std::vector<int>> answersOf(const RegistrationResult& result) {
  std::vector<std::vector<int>> maps;
  for (const HypothesisSummary& hypothesis : result.hypotheses)
    maps.push_back(hypothesis.target_vertex);
  for (const AlternativeSummary& alternative : result.alternatives)
    maps.push_back(alternative.target_vertex);
  return maps;
}

/// The places of a map at vertices, as the field measures it.
std::vector<SurfacePoint> atVertices(std::vector<SurfacePoint> places) {
  for (SurfacePoint& place : places) place.face = -1;
  return places;
}

Json judgeCandidates(const TargetMetric& metric,
                     const PairData& data,
                     const RegistrationResult& result) {
  const std::vector<CandidateError> errors = candidateErrors(metric, answersOf(result), data.truth);
  const int best = bestCandidate(errors);
  Json list = Json::array();
  for (const CandidateError& e : errors)
    list.push_back({{"mean_x100", 100 * e.mean}, {"share_mapped", e.share_mapped}});
  Json json{{"errors", std::move(list)}, {"best", best < 0 ? Json() : Json(best)}};
  if (best < 0 || result.chosen < 0) return json;
  json["best_mean_x100"] = 100 * errors[best].mean;
  json["chosen_mean_x100"] = 100 * errors[result.chosen].mean;
  json["chose_wrong"] = choseWrong(errors[result.chosen], errors[best]);
  return json;
}

void judge(const PairData& data, const RegistrationResult& result, Json& json) {
  const std::vector<SurfacePoint>& map = result.correspondence.on_target;
  if (!data.truth.empty()) {
    const TargetMetric metric(data.target);
    json["errors"] = toJson(measureErrors(metric, atVertices(map), data.truth));
    json["subvertex_mean_x100"] = 100 * mean(measureErrors(metric, map, data.truth).relative_error);
    json["candidates"] = judgeCandidates(metric, data, result);
    if (!data.mirror_truth.empty())
      json["mirror"] = toJson(compareWithMirror(metric, map, data.truth, data.mirror_truth));
  }
  if (result.deformed.rows() == 0) return;
  const SurfaceFit fit = measureFit(data.source, result.deformed, result.scale, data.target);
  json["fit"] = {{"median_distance", fit.median_distance},
                 {"percentile_95_distance", fit.percentile_95_distance},
                 {"mean_stretch", fit.mean_stretch},
                 {"percentile_95_stretch", fit.percentile_95_stretch}};
}

Json registerAndJudge(const BenchmarkPair& pair,
                      Method method,
                      const PairData& data,
                      double read_seconds) {
  const auto start = Clock::now();
  RegistrationOptions options;
  options.method = method;
  const RegistrationResult result = registerShapes(data.source, data.target, options);
  const double seconds = read_seconds + secondsSince(start);
  const double memory = peakMemoryMib();

  const auto& places = result.correspondence.on_target;
  const auto accepted = std::count_if(
      places.begin(), places.end(), [](const SurfacePoint& p) { return p.vertex >= 0; });
  Json json = describePair(pair, method);
  json["status"] = result.status == Status::REGISTERED ? "registered" : "undecided";
  json["message"] = result.message;
  if (!result.hypotheses.empty())
    json["consistency"] = result.hypotheses[result.chosen].consistency;
  if (method == Method::REFINED) json["trust"] = result.trust;
  if (!result.alternatives.empty()) json["score"] = result.score;
  json["source_vertices"] = data.source.vertices.rows();
  json["target_vertices"] = data.target.vertices.rows();
  json["samples"] = result.source.samples;
  json["accepted"] = accepted;
  json["rejected"] = static_cast<std::ptrdiff_t>(places.size()) - accepted;
  json["chosen"] = result.chosen < 0 ? Json() : Json(result.chosen);
  json["seconds"] = seconds;
  Json& stages = json["stages"] = Json::object();
  for (const StageTiming& t : result.timings)
    stages[t.stage] = stages.value(t.stage, 0.0) + t.seconds;
  json["peak_memory_mib"] = memory;
  json["threads"] = omp_get_max_threads();
  judge(data, result, json);
  return json;
}

}  // namespace

Json describePair(const BenchmarkPair& pair, Method method) {
  return {{"id", pair.id},
          {"method", method == Method::PAPER ? "paper" : "refined"},
          {"family", pair.family},
          {"kind", pair.kind},
          {"source", pair.source.string()},
          {"target", pair.target.string()},
          {"truth", pair.truth.string()},
          {"mirror_truth", pair.mirror_truth.string()},
          {"note", pair.note}};
}

Json failedPair(const BenchmarkPair& pair,
                Method method,
                const std::string& status,
                const std::string& message) {
  Json json = describePair(pair, method);
  json["status"] = status;
  json["message"] = message;
  return json;
}

Json runPair(const BenchmarkPair& pair, Method method) {
  bool points_only = false;
  try {
    const auto [data, read_seconds] = readPair(pair);
    points_only = data.source.faces.rows() == 0 || data.target.faces.rows() == 0;
    return registerAndJudge(pair, method, data, read_seconds);
  } catch (const InputError& error) {
    return failedPair(
        pair,
        method,
        "not run",
        (points_only ? "unsupported: points only: " : "") + std::string(error.what()));
  }
}

}  // namespace posture::app
