// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "judge_map.h"

#include <posture/evaluation/map_error.h>
#include <posture/evaluation/statistics.h>

#include "error_json.h"

namespace posture::app {
namespace {

std::vector<SurfacePoint> atVertices(std::vector<SurfacePoint> places) {
  for (SurfacePoint& place : places) place.face = -1;
  return places;
}

}  // namespace

Json judgeMap(const TargetPlaces& target,
              const TargetMetric& metric,
              const std::vector<SurfacePoint>& on_target,
              const std::vector<VertexPair>& truth,
              const std::vector<VertexPair>& mirror_truth) {
  const std::vector<SurfacePoint> map = target.onMesh(on_target), at_vertices = atVertices(map);
  const std::vector<VertexPair> pairs = target.onMesh(truth);
  MapErrors errors = measureErrors(metric, at_vertices, pairs);
  // Counterparts, be there a place to measure them at or not.
  errors.accepted = static_cast<int>(mappedCount(on_target));
  Json json{{"errors", toJson(errors)}};
  json["subvertex_mean_x100"] = 100 * mean(measureErrors(metric, map, pairs).relative_error);
  if (mirror_truth.empty()) return json;
  const MirrorComparison mirror =
      compareWithMirror(metric, at_vertices, pairs, target.onMesh(mirror_truth));
  if (mirror.pairs > 0) json["mirror"] = toJson(mirror);
  return json;
}

}  // namespace posture::app
