// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "published/hypothesis.h"

#include <posture/core/parallel.h>
#include <posture/matching/consistency.h>

#include <algorithm>
#include <utility>

namespace posture {
std::vector<Matrix> consistencyMatrices(const std::vector<Candidate>& candidates,
                                        const Landmarks& source,
                                        const Landmarks& target) {
  const Matrix source_distances = sampleDistances(source),
               target_distances = sampleDistances(target);
  std::vector<Matrix> matrices(candidates.size());
  parallelFor(static_cast<int>(candidates.size()), [&](int k) {
    matrices[k] = consistencyMatrix(candidates[k].matches, source_distances, target_distances);
  });
  return matrices;
}

Hypothesis evaluateCandidate(const EmbeddedShape& source,
                             const EmbeddedShape& target,
                             const Candidate& candidate,
                             const Matrix& consistency,
                             double threshold) {
  Hypothesis h;
  h.candidate = candidate;
  const double m = static_cast<double>(consistency.rows());
  h.consistency = m > 1 ? (consistency.sum() - m) / (m * (m - 1)) : 0;
  h.kernel = consistencyKernel(consistency, threshold);
  h.map = computeDenseMap(source, target, candidate, h.kernel, threshold);
  const std::vector<VertexPair> pairs =
      oneToOne(h.map, static_cast<int>(target.mesh.vertices.rows()));
  h.common = computeCommonMeshes(source.mesh, target.mesh, pairs);
  h.source_energy = deformationEnergy(h.common.from_source);
  h.target_energy = deformationEnergy(h.common.from_target);
  return h;
}

int leastDeformed(const std::vector<Hypothesis>& hypotheses) {
  const auto best = std::min_element(
      hypotheses.begin(), hypotheses.end(), [](const Hypothesis& a, const Hypothesis& b) {
        return a.energy() < b.energy();
      });
  return static_cast<int>(best - hypotheses.begin());
}

std::vector<StagePicture> hypothesisPictures(const EmbeddedShape& source,
                                             const EmbeddedShape& target,
                                             const std::vector<Hypothesis>& hypotheses) {
  std::vector<StagePicture> pictures;
  for (std::size_t k = 0; k < hypotheses.size(); ++k) {
    const Hypothesis& h = hypotheses[k];
    const std::string name = "candidate-" + std::to_string(k);
    const int m = static_cast<int>(h.kernel.size());
    StagePicture matched_source{name + "-source-kernel", {Points(m, 3), {}}, Points(m, 3), {}};
    StagePicture matched_target{name + "-target-kernel", {Points(m, 3), {}}, Points(m, 3), {}};
    for (int i = 0; i < m; ++i) {
      const Match& match = h.candidate.matches[h.kernel[i]];
      const auto place = source.mesh.vertices.row(source.landmarks.vertices[match.source]);
      matched_source.mesh.vertices.row(i) = matched_source.place.row(i) = place;
      matched_target.place.row(i) = place;
      matched_target.mesh.vertices.row(i) =
          target.mesh.vertices.row(target.landmarks.vertices[match.target]);
    }
    pictures.push_back(std::move(matched_source));
    pictures.push_back(std::move(matched_target));
    const CommonMesh &m0 = h.common.from_source, &m1 = h.common.from_target;
    pictures.push_back({name + "-m0-on-source", {m0.source, m0.faces}, m0.source, {}});
    pictures.push_back({name + "-m0-on-target", {m0.target, m0.faces}, m0.source, {}});
    pictures.push_back({name + "-m1-on-source", {m1.source, m1.faces}, m1.source, {}});
    pictures.push_back({name + "-m1-on-target", {m1.target, m1.faces}, m1.source, {}});
  }
  return pictures;
}

}  // namespace posture
