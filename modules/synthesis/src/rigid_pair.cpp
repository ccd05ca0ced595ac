// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/compact_vertices.h>
#include <posture/synthesis/rigid_pair.h>

#include "keep_vertices.h"
#include <cmath>
#include <vector>

namespace posture {
namespace {

using namespace synthesis;

constexpr double MISSING = 0.2;  // of the length
constexpr double TURN = 0.1;     // radians
constexpr double SHIFT = 0.04;   // of the length

/// What lies between two places along an axis.
void crop(ArticulatedBody& body, int axis, double low, double high) {
  const TriangleMesh& mesh = body.mesh;
  const auto isInside = [&](int v) {
    return mesh.vertices(v, axis) >= low && mesh.vertices(v, axis) <= high;
  };
  std::vector<int> inside;
  for (int f = 0; f < mesh.faces.rows(); ++f)
    if (isInside(mesh.faces(f, 0)) && isInside(mesh.faces(f, 1)) && isInside(mesh.faces(f, 2)))
      inside.push_back(f);
  PunchedMesh left{mesh.faces(inside, Eigen::all), {}};
  left.survivor = compactVertices(left.faces, static_cast<int>(mesh.vertices.rows()));
  keepVertices(body, left);
}

}  // namespace

RigidPair makeRigidPair(const BodyOptions& options) {
  BodyOptions again = options;
  ++again.tessellation;
  RigidPair pair{makeBody(options), makeBody(again), Eigen::Isometry3d::Identity()};

  const Points& whole = pair.target.mesh.vertices;
  const Eigen::Vector3d low = whole.colwise().minCoeff(), high = whole.colwise().maxCoeff();
  int axis = 0;
  const double length = (high - low).maxCoeff(&axis);
  const Eigen::Vector3d middle = (low + high) / 2;
  crop(pair.source, axis, low[axis] + MISSING * length, HUGE_VAL);
  crop(pair.target, axis, -HUGE_VAL, high[axis] - MISSING * length);

  Eigen::Isometry3d away = Eigen::Isometry3d::Identity();
  away.translate(middle + SHIFT * length * Eigen::Vector3d(1, 2, -2) / 3);
  away.rotate(Eigen::AngleAxisd(TURN, Eigen::Vector3d(2, -1, 3).normalized()));
  away.translate(-middle);
  Points& source = pair.source.mesh.vertices;
  source = ((source * away.linear().transpose()).rowwise() + away.translation().transpose()).eval();
  pair.T_target_source = away.inverse();
  return pair;
}

}  // namespace posture
