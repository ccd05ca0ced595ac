// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/median.h>
#include <posture/mesh/deformation_scale.h>
#include <posture/mesh/edges.h>
#include <posture/mesh/vertex_neighbors.h>

#include <utility>
#include <vector>

namespace posture {

double medianEdgeRatio(const TriangleMesh& mesh, const Points& places) {
  std::vector<double> ratios;
  for (const Edge& e : meshEdges(mesh.faces)) {
    const double before = (mesh.vertices.row(e.first) - mesh.vertices.row(e.second)).norm();
    const double after = (places.row(e.first) - places.row(e.second)).norm();
    if (before > 0 && after > 0) ratios.push_back(after / before);
  }
  return ratios.empty() ? 1 : median(std::move(ratios));
}

double scaleWithoutNoise(const TriangleMesh& mesh, const Points& places) {
  constexpr int PASSES = 5;
  const int n = static_cast<int>(places.rows());
  const VertexNeighbors neighbors(mesh.faces, n);
  const auto smoothed = [&](Points at) {
    for (int pass = 0; pass < PASSES; ++pass) {
      const Points before = at;
      for (int v = 0; v < n; ++v) {
        double count = 1;
        for (const int* w = neighbors.begin(v); w != neighbors.end(v); ++w, ++count)
          at.row(v) += before.row(*w);
        at.row(v) /= count;
      }
    }
    return at;
  };
  return medianEdgeRatio({smoothed(mesh.vertices), mesh.faces}, smoothed(places));
}

}  // namespace posture
