// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/error.h>
#include <posture/synthesis/articulated_body.h>

#include "nearest_places.h"
#include <algorithm>

namespace posture {

using namespace synthesis;

namespace {

double meanEdge(const Faces& faces, const Points& places) {
  double sum = 0;
  for (int f = 0; f < faces.rows(); ++f)
    for (int i = 0; i < 3; ++i)
      sum += (places.row(faces(f, i)) - places.row(faces(f, (i + 1) % 3))).norm();
  return sum / static_cast<double>(std::max<Eigen::Index>(3 * faces.rows(), 1));
}

double reachOf(const ArticulatedBody& target) {
  require(
      target.rest_position.rows() == target.mesh.vertices.rows() && target.mesh.faces.rows() > 0,
      "ground truth: the target has no rest places or no faces");
  return meanEdge(target.mesh.faces, target.rest_position);
}

}  // namespace

std::vector<VertexPair> groundTruth(const ArticulatedBody& source, const ArticulatedBody& target) {
  return nearestPairs(source.rest_position, target.rest_position, reachOf(target));
}

std::vector<VertexPair> mirrorTruth(const ArticulatedBody& source, const ArticulatedBody& target) {
  return nearestPairs(
      mirrored(source.rest_position), target.rest_position, reachOf(target) + ASYMMETRY);
}

}  // namespace posture
