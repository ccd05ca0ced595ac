// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "benchmark_pair.h"

#include <posture/core/error.h>
#include <posture/core/finite_rows.h>
#include <posture/core/seconds_since.h>
#include <posture/evaluation/map_error.h>
#include <posture/report/peak_memory.h>

#include "child_run.h"
#include "judge_map.h"
#include "pair_data.h"
#include "register_files.h"
#include <chrono>
#include <omp.h>

namespace posture::app {
namespace {

/// The answers that the method chose among.
std::vector<std::vector<int>> answersOf(const RegistrationResult& result) {
  std::vector<std::vector<int>> maps;
  for (const HypothesisSummary& hypothesis : result.hypotheses)
    maps.push_back(hypothesis.target_vertex);
  for (const AlternativeSummary& alternative : result.alternatives)
    maps.push_back(alternative.target_vertex);
  return maps;
}

Json judgeCandidates(const TargetMetric& metric,
                     const TargetPlaces& target,
                     const std::vector<VertexPair>& truth,
                     const RegistrationResult& result) {
  std::vector<std::vector<int>> answers = answersOf(result);
  for (std::vector<int>& answer : answers) answer = target.onMesh(answer);
  const std::vector<CandidateError> errors = candidateErrors(metric, answers, truth);
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

void judgeErrors(const BenchmarkPair& pair,
                 const PairData& data,
                 const RegistrationResult& result,
                 Json& json) {
  const TargetPlaces target = placesOf(pair, data, result.target_scan);
  const TargetMetric metric = target.metric();
  json.update(
      judgeMap(target, metric, result.correspondence.on_target, data.truth, data.mirror_truth));
  json["candidates"] = judgeCandidates(metric, target, target.onMesh(data.truth), result);
}

void judgeFit(const PairData& data, const RegistrationResult& result, Json& json) {
  const SurfaceFit fit = fitOf(data.source, data.target, result);
  json["fit"] = {{"median_distance", fit.median_distance},
                 {"percentile_95_distance", fit.percentile_95_distance},
                 {"mean_stretch", fit.mean_stretch},
                 {"percentile_95_stretch", fit.percentile_95_stretch}};
}

Json registerAndJudge(const BenchmarkPair& pair, Method method, const PairData& data) {
  const auto start = std::chrono::steady_clock::now();
  RegistrationOptions options;
  options.method = method;
  const RegistrationResult result =
      registerFiles(pair.source, data.source, pair.target, data.target, options);
  const double seconds = data.read_seconds + secondsSince(start);
  const double memory = peakMemoryMib();

  const long accepted = mappedCount(result.correspondence.on_target);
  Json json = describePair(pair, nameOf(method));
  json["status"] = result.status == Status::REGISTERED ? "registered" : "undecided";
  json["message"] = result.message;
  if (!result.hypotheses.empty())
    json["consistency"] = result.hypotheses[result.chosen].consistency;
  if (method == Method::REFINED) json["trust"] = result.trust;
  if (!result.alternatives.empty()) {
    json["score"] = result.score;
    json["hands"] = result.hands;
  }
  json["source_vertices"] = presentCount(result);
  json["target_vertices"] = finiteRows(data.target.cloud.points).size();
  json["samples"] = result.source.samples;
  json["accepted"] = accepted;
  json["rejected"] = presentCount(result) - accepted;
  json["chosen"] = result.chosen < 0 ? Json() : Json(result.chosen);
  json["seconds"] = seconds;
  Json stages = Json::object(), further_attempts = Json::object();
  for (const StageTiming& t : result.timings) {
    Json& sums = t.attempt.empty() ? stages : further_attempts;
    const std::string& name = t.attempt.empty() ? t.stage : t.attempt;
    sums[name] = sums.value(name, 0.0) + t.seconds;
  }
  json["stages"] = stages;
  json["further_attempts"] = further_attempts;
  json["peak_memory_mib"] = memory;
  json["threads"] = omp_get_max_threads();
  if (!data.truth.empty()) judgeErrors(pair, data, result, json);
  if (result.deformed.rows() > 0) judgeFit(data, result, json);
  return json;
}

}  // namespace

std::string nameOf(Method method) { return method == Method::PAPER ? "paper" : "refined"; }

Json runPair(const BenchmarkPair& pair, Method method) {
  try {
    return registerAndJudge(pair, method, readPair(pair));
  } catch (const InputError& error) {
    return failedRun(describePair(pair, nameOf(method)), "not run", error.what());
  }
}

}  // namespace posture::app
