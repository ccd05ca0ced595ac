// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/correspondence.h>
#include <posture/core/types.h>

#include <cstdint>
#include <string>
#include <vector>

namespace posture {

enum class BodyKind { QUADRUPED, HUMAN };

/// How a body is made. Lengths in the body's own unit: it is about 1 long (or tall).
struct BodyOptions {
  BodyKind kind = BodyKind::QUADRUPED;
  int pose = 0;              ///< 0 is the rest pose; any other number is another pose
  int vertices = 5000;       ///< about so many
  int tessellation = 0;      ///< another number meshes the same body anew
  int holes = 0;             ///< punched at seeded places
  double hole_radius = 0.02; ///< geodesic, in body units
  double noise = 0;          ///< standard deviation along the normal, in body units
  std::uint64_t seed = 1;    ///< of holes and noise
};

/// A closed (unless holes are asked for) articulated surface in one pose.
struct ArticulatedBody {
  TriangleMesh mesh;
  /// For each vertex its place on the body in the rest pose (n x 3): equal places correspond,
  /// whatever the pose and the tessellation.
  Points rest_position;
  std::vector<int> bone;               ///< n: the bone that moves the vertex most
  std::vector<std::string> bone_names;
  std::vector<Eigen::Isometry3d> bone_motion;  ///< rest -> pose, one a bone
};

ArticulatedBody makeBody(const BodyOptions& options);

/// The true counterpart of every source vertex: the target vertex whose rest place is nearest,
/// left out where the target has no surface there (a hole).
std::vector<VertexPair> groundTruth(const ArticulatedBody& source, const ArticulatedBody& target);

}  // namespace posture
