// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sides/leave_out_background.h"

#include <posture/mesh/background.h>
#include <posture/mesh/rigid_motion.h>

#include <algorithm>
#include <cstddef>

namespace posture {
namespace {

void dropRows(const Background& background, std::vector<int>& map) {
  for (std::size_t v = 0; v < std::min(map.size(), background.vertices.size()); ++v)
    if (background.vertices[v] != 0) map[v] = -1;
}

void moveAsAWhole(const Background& background, const Points& at_rest, RegistrationResult& result) {
  std::vector<int> behind, body;
  for (int v = 0; v < at_rest.rows(); ++v)
    (background.vertices[v] != 0 ? behind : body).push_back(v);
  const Points scaled = result.scale * at_rest;
  const Eigen::Isometry3d motion =
      rigidMotion(scaled(body, Eigen::all), result.deformed(body, Eigen::all));
  result.deformed(behind, Eigen::all) = moved(motion, scaled(behind, Eigen::all));
}

}  // namespace

Background leaveOutBackground(TriangleMesh& mesh) {
  const std::vector<char> background = backgroundFaces(mesh);
  Background found;
  found.faces = static_cast<int>(std::count(background.begin(), background.end(), 1));
  if (found.faces == 0) return found;
  found.vertices.assign(mesh.vertices.rows(), 0);
  for (const char of_background : {1, 0})
    for (int f = 0; f < mesh.faces.rows(); ++f)
      if (background[f] == of_background)
        for (int v : mesh.faces.row(f)) found.vertices[v] = of_background;
  for (int f = 0; f < mesh.faces.rows(); ++f) {
    if (background[f] == 0) continue;
    // Not one of the body's, if there is another: points in the face go where that goes.
    auto corners = mesh.faces.row(f);
    const auto own =
        std::find_if(corners.begin(), corners.end(), [&](int v) { return found.vertices[v] != 0; });
    const int corner = own != corners.end() ? *own : corners[0];
    corners.setConstant(corner);
  }
  return found;
}

void dropBackground(const Background& source,
                    const Points& at_rest,
                    const Background& target,
                    RegistrationResult& result) {
  if (source.faces > 0 && result.deformed.rows() > 0) moveAsAWhole(source, at_rest, result);
  dropRows(source.vertices, target.vertices, result.correspondence);
  if (result.back) dropRows(target.vertices, source.vertices, result.back->correspondence);
  for (AlternativeSummary& alternative : result.alternatives) {
    dropRows(source.vertices, target.vertices, alternative.correspondence);
    dropRows(source, alternative.target_vertex);
  }
  for (HypothesisSummary& hypothesis : result.hypotheses)
    dropRows(source, hypothesis.target_vertex);
}

}  // namespace posture
