// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/median.h>
#include <posture/refine/conform.h>

#include "belief.h"
#include "nearest_rows.h"
#include "pose_features.h"
#include "robust_weight.h"
#include <algorithm>
#include <vector>

namespace posture {
namespace {

/// Features of a third to a twentieth of the square root of the area keep their shape.
constexpr double SOFTNESS[] = {10, 30, 100, 300};
constexpr int CONFORMING_STEPS = 4;

/// What is nearest in both poses, both ways.
VertexMaps nearestInBothPoses(const BendableSurface& a,
                              const BendableSurface& b,
                              double softness,
                              const BentPair& pair) {
  const PoseFeaturePair of = poseFeatures(a, b, softness, pair);
  VertexMaps maps;
  nearestAmongGroups(of.a.transpose(), of.b.transpose(), maps.forward, maps.backward);
  return maps;
}

/// Pulls a surface towards its matches; far ones count less the farther they are beyond twice the
/// usual distance.
void pullRobustly(const BendableSurface& from,
                  const BendableSurface& to,
                  const std::vector<int>& matches,
                  double softness,
                  Points& bent) {
  const Points goals = to.mesh.vertices(matches, Eigen::all);
  const Vector distance = (goals - bent).rowwise().norm();
  const double usual =
      2 * std::max(median({distance.data(), distance.data() + distance.size()}), 1e-3);
  Vector believed = belief(from, to, matches);
  for (Eigen::Index v = 0; v < distance.size(); ++v) {
    const double ratio = distance[v] / usual;
    believed[v] *= gemanMcClure(ratio * ratio);
  }
  bent = from.arap.pull(bent, goals, from.arap.attract(softness, believed), BENDING_STEPS);
}

}  // namespace

BentPair conform(const BendableSurface& a,
                 const BendableSurface& b,
                 const Points& laid,
                 const Points& back) {
  BentPair pair{{}, laid, back};
  for (const double softness : SOFTNESS) {
    for (int step = 0; step < CONFORMING_STEPS; ++step) {
      pair.maps = nearestInBothPoses(a, b, softness, pair);
      pullRobustly(a, b, pair.maps.forward, softness, pair.bent_a);
      pullRobustly(b, a, pair.maps.backward, softness, pair.bent_b);
    }
    pair.maps = nearestInBothPoses(a, b, softness, pair);
  }
  return pair;
}

}  // namespace posture
