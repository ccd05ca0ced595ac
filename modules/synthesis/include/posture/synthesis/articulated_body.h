// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/correspondence.h>
#include <posture/core/types.h>

#include <Eigen/Geometry>

#include <cstdint>
#include <string>
#include <vector>

namespace posture {

enum class BodyKind { QUADRUPED, HUMAN };

/// How a body is made. Lengths in the body's own unit: it is about 1 long (or tall).
struct BodyOptions {
  BodyKind kind = BodyKind::QUADRUPED;
  int pose = 0;               ///< 0: rest; 1 to 9: made by hand; any other number: random joints
  int vertices = 5000;        ///< about so many (within 10 %), before holes are cut
  int tessellation = 0;       ///< another number meshes the same body anew
  int holes = 0;              ///< punched at seeded places
  double hole_radius = 0.02;  ///< geodesic, in body units
  double noise = 0;           ///< standard deviation along the normal, in body units
  std::uint64_t seed = 1;     ///< of holes and noise, which differ with pose and tessellation too
};

/// A closed (unless holes are asked for) articulated surface in one pose. In the rest pose the body
/// stands on z = 0 and looks along +y; x = 0 is its plane of near symmetry.
struct ArticulatedBody {
  TriangleMesh mesh;
  /// For each vertex its place on the body in the rest pose (n x 3): equal places correspond,
  /// whatever the pose and the tessellation.
  Points rest_position;
  std::vector<int> bone;  ///< n: the bone that moves the vertex most
  Vector bone_weight;     ///< n, in (0, 1]: that bone's share; 1 where the vertex moves rigidly
  std::vector<std::string> bone_names;
  std::vector<Eigen::Isometry3d> bone_motion;  ///< rest -> pose, one a bone
};

/// \throws std::invalid_argument  fewer than 1000 vertices, a negative length or count, or more
///         holes than fit and leave most of the body in one piece.
ArticulatedBody makeBody(const BodyOptions& options);

/// The true counterpart of every source vertex: the target vertex whose rest place is nearest,
/// left out where there is none within the target's mean edge length: in a hole, and here and there
/// in the middle of a face with much longer edges.
std::vector<VertexPair> groundTruth(const ArticulatedBody& source, const ArticulatedBody& target);

/// The same for the answer that took left for right: the rest place reflected in x = 0, and the
/// reach larger by as much as the body's sides differ.
std::vector<VertexPair> mirrorTruth(const ArticulatedBody& source, const ArticulatedBody& target);

}  // namespace posture
