// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "outcome/drop_background.h"

#include <posture/mesh/rigid_motion.h>

#include <algorithm>
#include <cstddef>
#include <vector>

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
