// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/refine/carry_up.h>

#include <algorithm>
#include <vector>

namespace posture {
namespace {

/// Every vertex of the full mesh moves as the reduced vertices around it do.
Points prolong(const TriangleMesh& full, const ReducedMesh& reduced, const Points& bent) {
  const BendableSurface work(reduced.mesh);
  const std::vector<Eigen::Matrix3d> rotation = work.arap.rotations(bent);
  Points places(full.vertices.rows(), 3);
  for (int v = 0; v < places.rows(); ++v) {
    const int nearest = reduced.nearest[v];
    const Eigen::Vector3d x = full.vertices.row(v);
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    double weight = 0;
    const auto add = [&](int w) {
      const Eigen::Vector3d from = x - work.mesh.vertices.row(w).transpose();
      const double share = 1 / (from.squaredNorm() + 1e-12);
      sum += share * (bent.row(w).transpose() + rotation[w] * from);
      weight += share;
    };
    add(nearest);
    std::for_each(work.neighbors.begin(nearest), work.neighbors.end(nearest), add);
    places.row(v) = (sum / weight).transpose();
  }
  return places;
}

}  // namespace

BentPair carryUp(const TriangleMesh& a,
                 const ReducedMesh& reduced_a,
                 const TriangleMesh& b,
                 const ReducedMesh& reduced_b,
                 const BentPair& pair) {
  const auto matches =
      [](const ReducedMesh& from, const std::vector<int>& map, const ReducedMesh& to) {
        std::vector<int> full(from.nearest.size());
        for (std::size_t v = 0; v < full.size(); ++v) full[v] = to.vertex[map[from.nearest[v]]];
        return full;
      };
  const auto apart = [](const ReducedMesh& of, const std::vector<char>& reduced) {
    std::vector<char> full;
    if (!reduced.empty())
      for (int v : of.nearest) full.push_back(reduced[v]);
    return full;
  };
  return {{matches(reduced_a, pair.maps.forward, reduced_b),
           matches(reduced_b, pair.maps.backward, reduced_a)},
          prolong(a, reduced_a, pair.bent_a),
          prolong(b, reduced_b, pair.bent_b),
          apart(reduced_a, pair.apart_a),
          apart(reduced_b, pair.apart_b)};
}

}  // namespace posture
