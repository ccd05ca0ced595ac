// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "compare_run.h"

#include <posture/baselines/rigid_registration.h>
#include <posture/core/error.h>
#include <posture/core/finite_rows.h>
#include <posture/core/seconds_since.h>
#include <posture/evaluation/closeness.h>
#include <posture/mesh/normals.h>
#include <posture/mesh/point_index.h>
#include <posture/mesh/rigid_motion.h>
#include <posture/report/peak_memory.h>

#include "child_run.h"
#include "compare_variation.h"
#include "judge_map.h"
#include "pair_data.h"
#include "register_files.h"
#include <omp.h>

namespace posture::app {
namespace {

/// What a method made of a source, its rows in the order of that source.
struct Outcome {
  std::string status, message;
  Points registered;  ///< in the target's frame; 0 x 3: nothing came out
  std::vector<SurfacePoint> on_target;
  std::optional<RegistrationResult> bent;  ///< where the source is
  std::optional<double> trust;
  std::optional<ScanSurface> target_scan;
};

Outcome registerByPosture(const BenchmarkPair& pair, const Shape& source, const Shape& target) {
  RegistrationResult result = registerFiles(pair.source, source, pair.target, target);
  Outcome outcome;
  outcome.status = result.status == Status::REGISTERED ? "registered" : "undecided";
  outcome.message = result.message;
  outcome.trust = result.trust;
  outcome.target_scan = result.target_scan;
  if (result.deformed.rows() > 0) {
    outcome.registered = result.deformed;
    outcome.on_target = result.correspondence.on_target;
    outcome.bent = std::move(result);
  }
  return outcome;
}

/// A mesh's normals are those of its faces.
PointCloud cloudOf(const Shape& shape) {
  PointCloud cloud = shape.cloud;
  if (shape.faces.rows() > 0) cloud.normals = vertexNormals({cloud.points, shape.faces});
  return cloud;
}

/// To each point the nearest of the target's; points that were not seen have none.
std::vector<SurfacePoint> nearestPoints(const Points& registered, const Points& target) {
  const std::vector<int> seen = finiteRows(target);
  const PointIndex index(target(seen, Eigen::all));
  std::vector<SurfacePoint> places(registered.rows());
  for (int i : finiteRows(registered))
    places[i].vertex = seen[index.nearest(registered.row(i)).index];
  return places;
}

Outcome moveAsAWhole(const Shape& source, const Shape& target, const RigidResult& motion) {
  Outcome outcome;
  outcome.message = motion.failure;
  outcome.status = motion.converged ? "converged" : "not converged";
  if (!motion.failure.empty()) {
    outcome.status = "failed";
    return outcome;
  }
  outcome.registered = moved(motion.T_target_source, source.cloud.points);
  outcome.on_target = nearestPoints(outcome.registered, target.cloud.points);
  return outcome;
}

RigidResult registerRigid(const ComparedRun& run,
                          RigidMethod method,
                          const Shape& source,
                          const Shape& target) {
  try {
    return registerRigidly(method, cloudOf(source), cloudOf(target), run.seed);
  } catch (const InputError& error) {
    // It does not say which side.
    throw InputError(run.pair.source.string() + " onto " + run.pair.target.string() + ": " +
                     error.what());
  }
}

Outcome apply(const ComparedRun& run, const Shape& source, const Shape& target) {
  if (run.method == "posture") return registerByPosture(run.pair, source, target);
  if (run.method == "as-given") {
    Outcome outcome = moveAsAWhole(source, target, {});
    outcome.status = "as given";
    return outcome;
  }
  for (RigidMethod method : rigidMethods())
    if (keyOf(method) == run.method)
      return moveAsAWhole(source, target, registerRigid(run, method, source, target));
  throw std::invalid_argument("no method '" + run.method + "'");
}

/// Into the order as given.
void restoreOrder(const std::vector<int>& given, Outcome& outcome) {
  if (outcome.registered.rows() == 0) return;
  const Points registered = outcome.registered;
  const std::vector<SurfacePoint> places = outcome.on_target;
  for (std::size_t i = 0; i < given.size(); ++i) {
    outcome.registered.row(given[i]) = registered.row(static_cast<Eigen::Index>(i));
    outcome.on_target[given[i]] = places[i];
  }
}

void judge(const BenchmarkPair& pair, const PairData& data, const Outcome& outcome, Json& json) {
  json["mapped"] = mappedCount(outcome.on_target);
  const Closeness close = measureCloseness(outcome.registered, data.target.cloud.points);
  json["mean_distance"] = close.mean_distance;
  json["source_near"] = close.moved_near;
  json["target_near"] = close.target_near;
  if (data.truth.empty()) return;
  const TargetPlaces target = placesOf(pair, data, outcome.target_scan);
  json.update(judgeMap(target, target.metric(), outcome.on_target, data.truth, data.mirror_truth));
}

Json registerAndJudge(const ComparedRun& run) {
  const PairData data = readPair(run.pair);
  const VariedShape source = vary(data.source, run.variation);
  const auto start = std::chrono::steady_clock::now();
  Outcome outcome;
  try {
    outcome = apply(run, source.shape, data.target);
  } catch (const InputError& error) {
    return failedRun(describeRun(run), "refused", error.what());
  }
  const double seconds = data.read_seconds + secondsSince(start);
  const double memory = peakMemoryMib();
  // A rigid motion stretches nothing.
  const double stretch =
      outcome.bent ? fitOf(source.shape, data.target, *outcome.bent).mean_stretch : 0;
  restoreOrder(source.given, outcome);

  Json json = describeRun(run);
  json["status"] = outcome.status;
  json["message"] = outcome.message;
  if (outcome.trust) json["trust"] = *outcome.trust;
  json["source_vertices"] = finiteRows(data.source.cloud.points).size();
  json["target_vertices"] = finiteRows(data.target.cloud.points).size();
  json["seconds"] = seconds;
  json["peak_memory_mib"] = memory;
  json["threads"] = omp_get_max_threads();
  if (outcome.registered.rows() > 0) {
    json["stretch"] = stretch;
    judge(run.pair, data, outcome, json);
  }
  return json;
}

}  // namespace

const std::vector<ComparedMethod>& comparedMethods() {
  static const std::vector<ComparedMethod> METHODS = [] {
    std::vector<ComparedMethod> methods{{"posture", "posture"}, {"as-given", "as given"}};
    for (RigidMethod method : rigidMethods()) methods.push_back({keyOf(method), nameOf(method)});
    return methods;
  }();
  return METHODS;
}

Json describeRun(const ComparedRun& run) {
  Json json = describePair(run.pair, run.method);
  json["variation"] = run.variation;
  json["seed"] = run.seed;
  return json;
}

ComparedRun comparedRun(const Json& described) {
  const auto text = [&](const char* key) { return described.at(key).get<std::string>(); };
  ComparedRun run;
  run.pair = {text("id"),
              text("family"),
              text("kind"),
              text("source"),
              text("target"),
              text("truth"),
              text("mirror_truth"),
              text("note"),
              text("target_surface"),
              text("target_surface_vertices")};
  run.method = text("method");
  run.variation = text("variation");
  run.seed = described.at("seed");
  return run;
}

Json runCompared(const ComparedRun& run) {
  try {
    return registerAndJudge(run);
  } catch (const InputError& error) {
    return failedRun(describeRun(run), "not run", error.what());
  }
}

bool missedAll(const Json& result) {
  const std::string status = textAt(result, "status");
  return (status == "failed" || status == "refused") && !textAt(result, "truth").empty();
}

}  // namespace posture::app
