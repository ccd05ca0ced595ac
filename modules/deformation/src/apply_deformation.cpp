// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/error.h>
#include <posture/core/parallel.h>
#include <posture/deformation/apply_deformation.h>
#include <posture/deformation/arap.h>
#include <posture/mesh/edges.h>
#include <posture/mesh/point_index.h>
#include <posture/mesh/vertex_neighbors.h>

#include <Eigen/Dense>

#include <algorithm>
#include <vector>

namespace posture {
namespace {

using Eigen::Vector3d;

/// Vertices near a point that are joined to each other within a distance of it.
class JoinedNearby {
 public:
  JoinedNearby(const TriangleMesh& mesh, const VertexNeighbors& neighbors)
      : mesh_(mesh), neighbors_(neighbors), seen_(mesh.vertices.rows(), -1) {}

  const std::vector<int>& find(int query, const Vector3d& point, int nearest, double reach) {
    found_.assign(1, nearest);
    seen_[nearest] = query;
    for (std::size_t i = 0; i < found_.size(); ++i) {
      const int v = found_[i];
      for (const int* w = neighbors_.begin(v); w != neighbors_.end(v); ++w) {
        if (seen_[*w] == query) continue;
        seen_[*w] = query;
        if ((mesh_.vertices.row(*w).transpose() - point).norm() < reach) found_.push_back(*w);
      }
    }
    return found_;
  }

 private:
  const TriangleMesh& mesh_;
  const VertexNeighbors& neighbors_;
  std::vector<int> seen_, found_;
};

}  // namespace

double deformationScale(const TriangleMesh& source, const Points& deformed) {
  std::vector<double> ratios;
  for (const Edge& e : meshEdges(source.faces)) {
    const double before = (source.vertices.row(e.first) - source.vertices.row(e.second)).norm();
    const double after = (deformed.row(e.first) - deformed.row(e.second)).norm();
    if (before > 0 && after > 0) ratios.push_back(after / before);
  }
  if (ratios.empty()) return 1;
  const auto middle = ratios.begin() + static_cast<std::ptrdiff_t>(ratios.size() / 2);
  std::nth_element(ratios.begin(), middle, ratios.end());
  return *middle;
}

Points applyDeformation(const TriangleMesh& source, const Points& deformed, const Points& points) {
  require(deformed.rows() == source.vertices.rows(), "applyDeformation: one place a vertex");
  require(source.vertices.rows() > 0, "applyDeformation: no vertices");
  const std::vector<Eigen::Matrix3d> rotation =
      Arap(source, cotangentLaplacian(source)).rotations(deformed);
  const double scale = deformationScale(source, deformed);
  const double edge = meanEdgeLength(source);
  const VertexNeighbors neighbors(source.faces, static_cast<int>(source.vertices.rows()));
  const PointIndex index(source.vertices);
  Points moved(points.rows(), 3);
  constexpr int SHARE = 1024;
  const int count = static_cast<int>(points.rows());
  parallelFor((count + SHARE - 1) / SHARE, [&](int share) {
    JoinedNearby nearby(source, neighbors);
    for (int i = share * SHARE; i < std::min(count, (share + 1) * SHARE); ++i) {
      const Vector3d x = points.row(i);
      const int nearest = index.nearest(x).index;
      const double distance = (source.vertices.row(nearest).transpose() - x).norm();
      if (distance == 0) {
        moved.row(i) = deformed.row(nearest);
        continue;
      }
      const double reach = 2 * (edge + distance);
      Vector3d sum = Vector3d::Zero();
      double weight = 0;
      for (int v : nearby.find(i, x, nearest, reach)) {
        const Vector3d from = x - source.vertices.row(v).transpose();
        const double fade = std::max(0.0, reach - from.norm()) / (reach * from.norm());
        const double share_of_v = fade * fade;
        sum += share_of_v * (deformed.row(v).transpose() + scale * (rotation[v] * from));
        weight += share_of_v;
      }
      moved.row(i) = (sum / weight).transpose();
    }
  });
  return moved;
}

}  // namespace posture
