// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/error.h>
#include <posture/core/rng.h>
#include <posture/synthesis/articulated_body.h>

#include "isosurface.h"
#include "keep_vertices.h"
#include "poses.h"
#include "remesh.h"
#include "scan_defects.h"
#include "skinning.h"
#include <cmath>
#include <string>

namespace posture {
namespace {

using namespace synthesis;

constexpr double LATTICE_SPACING = 0.0085;  // resolves ears, fingers and the gap between the legs

void check(const BodyOptions& options) {
  require(options.vertices >= 1000,
          "vertices " + std::to_string(options.vertices) + ", expected 1000 or more");
  require(options.holes >= 0, "holes " + std::to_string(options.holes) + ", expected 0 or more");
  require(std::isfinite(options.hole_radius) && options.hole_radius >= 0,
          "hole radius " + std::to_string(options.hole_radius) + ", expected 0 or more");
  require(std::isfinite(options.noise) && options.noise >= 0,
          "noise " + std::to_string(options.noise) + ", expected 0 or more");
}

/// Different poses and tessellations are different scans: their defects have nothing in common.
Rng defectRng(const BodyOptions& options) {
  const auto bits = [](int number) {
    return static_cast<std::uint64_t>(static_cast<std::int64_t>(number));
  };
  Rng mix(options.seed);
  Rng mix_pose(mix.next() + bits(options.pose));
  Rng mix_tessellation(mix_pose.next() + bits(options.tessellation));
  return Rng(mix_tessellation.next());
}

}  // namespace

namespace synthesis {

void keepVertices(ArticulatedBody& body, const PunchedMesh& left) {
  const std::vector<int>& kept = left.survivor;
  const Points posed = body.mesh.vertices, rest = body.rest_position;
  const std::vector<int> bone = body.bone;
  const Vector weight = body.bone_weight;
  const auto n = static_cast<Eigen::Index>(kept.size());
  body.mesh.faces = left.faces;
  body.mesh.vertices.resize(n, 3);
  body.rest_position.resize(n, 3);
  body.bone.resize(kept.size());
  body.bone_weight.resize(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    body.mesh.vertices.row(i) = posed.row(kept[i]);
    body.rest_position.row(i) = rest.row(kept[i]);
    body.bone[i] = bone[kept[i]];
    body.bone_weight[i] = weight[kept[i]];
  }
}

}  // namespace synthesis

ArticulatedBody makeBody(const BodyOptions& options) {
  check(options);
  const bool human = options.kind == BodyKind::HUMAN;
  const BodyShape shape = human ? humanShape() : quadrupedShape();
  const FleshField field(shape);

  ArticulatedBody body;
  body.mesh =
      remesh(isosurface(field, LATTICE_SPACING, options.tessellation), field, options.vertices);
  body.rest_position = body.mesh.vertices;
  const Matrix weights = skinWeights(shape, field, body.rest_position);
  body.bone.resize(weights.rows());
  body.bone_weight.resize(weights.rows());
  for (Eigen::Index i = 0; i < weights.rows(); ++i)
    body.bone_weight[i] = weights.row(i).maxCoeff(&body.bone[i]);
  for (const Bone& bone : shape.bones) body.bone_names.push_back(bone.name);
  body.bone_motion =
      boneMotions(shape, jointAngles(shape, human ? humanPoses() : quadrupedPoses(), options.pose));
  body.mesh.vertices = skin(body.rest_position, weights, body.bone_motion);

  Rng rng = defectRng(options);
  if (options.holes > 0)
    keepVertices(body, punchHoles(body.mesh, options.holes, options.hole_radius, rng));
  if (options.noise > 0) addNoise(body.mesh, options.noise, rng);
  return body;
}

}  // namespace posture
