// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pose_features.h"

#include <posture/mesh/normals.h>

#include <cmath>

namespace posture {
namespace {

PoseFeatures features(const Points& on_a,
                      const Points& normals_on_a,
                      const Points& on_b,
                      const Points& normals_on_b,
                      double normal_weight) {
  PoseFeatures f(12, on_a.rows());
  f.topRows(3) = on_a.transpose().cast<float>();
  f.middleRows(3, 3) = on_b.transpose().cast<float>();
  f.middleRows(6, 3) = (normal_weight * normals_on_a.transpose()).cast<float>();
  f.bottomRows(3) = (normal_weight * normals_on_b.transpose()).cast<float>();
  return f;
}

}  // namespace

PoseFeaturePair poseFeatures(const BendableSurface& a,
                             const BendableSurface& b,
                             double softness,
                             const BentPair& pair) {
  const double normal_weight = 1 / std::sqrt(softness);
  const Points bent_normals_a = vertexNormals({pair.bent_a, a.mesh.faces});
  const Points bent_normals_b = vertexNormals({pair.bent_b, b.mesh.faces});
  return {features(a.mesh.vertices, a.normals, pair.bent_a, bent_normals_a, normal_weight),
          features(pair.bent_b, bent_normals_b, b.mesh.vertices, b.normals, normal_weight)};
}

}  // namespace posture
