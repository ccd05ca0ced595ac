// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/compact_vertices.h>
#include <posture/core/error.h>
#include <posture/core/finite_rows.h>
#include <posture/core/parallel.h>
#include <posture/deformation/apply_deformation.h>
#include <posture/deformation/arap.h>
#include <posture/mesh/clean_mesh.h>
#include <posture/mesh/deformation_scale.h>
#include <posture/mesh/edges.h>
#include <posture/mesh/nearest_on_faces.h>
#include <posture/mesh/point_index.h>
#include <posture/mesh/require_mesh.h>
#include <posture/mesh/vertex_neighbors.h>
#include <posture/mesh/weld.h>

#include <Eigen/Dense>

#include <algorithm>
#include <vector>

namespace posture {
namespace {

using Eigen::Matrix3d, Eigen::Vector3d;

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

/// The frames of a surface's vertices, blended at points.
class FrameBlend {
 public:
  struct Share {
    int vertex;
    Vector3d from;  ///< the vertex to the point
    double weight;
  };

  FrameBlend(const TriangleMesh& source, const Points& deformed)
      : source_(source),
        edge_(meanEdgeLength(source)),
        neighbors_(source.faces, static_cast<int>(source.vertices.rows())),
        faces_at_(source.faces, static_cast<int>(source.vertices.rows())),
        index_(source.vertices),
        rotation_(Arap(source, cotangentLaplacian(source)).rotations(deformed)) {}

  const Matrix3d& rotation(int vertex) const { return rotation_[vertex]; }

  /// Calls body(i, shares) for each point, with the vertices that have a say in it.
  template <class Body>
  void forEach(const Points& points, const Body& body) const {
    forBlocks(static_cast<int>(points.rows()), [&](int first, int last) {
      JoinedNearby nearby(source_, neighbors_);
      std::vector<Share> shares;
      for (int i = first; i < last; ++i) {
        collect(i, points.row(i), nearby, shares);
        body(i, shares);
      }
    });
  }

 private:
  /// The place of the surface that is nearest to a point, among the faces at the nearest vertex.
  Vector3d foot(const Vector3d& x, int nearest) const {
    NearestPlace best(source_.vertices.row(nearest), x);
    lookAround(source_.vertices, source_.faces, faces_at_, nearest, x, best);
    return best.place;
  }

  /// Where a point is seen from: a far one no farther than some edges, or the whole surface would
  /// have a say in it.
  Vector3d viewpoint(const Vector3d& x, int nearest) const {
    constexpr double FARTHEST = 8;
    const double most = FARTHEST * edge_;
    if ((x - source_.vertices.row(nearest).transpose()).norm() <= most) return x;
    const Vector3d from = foot(x, nearest);
    const double distance = (x - from).norm();
    return distance <= most ? x : Vector3d(from + most / distance * (x - from));
  }

  void collect(int i, const Vector3d& x, JoinedNearby& nearby, std::vector<Share>& shares) const {
    int nearest = index_.nearest(x).index;
    const Vector3d seen = viewpoint(x, nearest);
    if (seen != x) nearest = index_.nearest(seen).index;
    const double distance = (source_.vertices.row(nearest).transpose() - seen).norm();
    shares.clear();
    const double reach = 2 * (edge_ + distance);
    for (int v : nearby.find(i, seen, nearest, reach)) {
      const Vector3d vertex = source_.vertices.row(v);
      const double length = (seen - vertex).norm();
      if (length == 0) {  // perhaps not the nearest one found, which is so to single precision
        shares.assign(1, {v, x - vertex, 1});
        return;
      }
      const double fade = std::max(0.0, reach - length) / (reach * length);
      shares.push_back({v, x - vertex, fade * fade});
    }
  }

  const TriangleMesh& source_;
  double edge_;
  VertexNeighbors neighbors_;
  VertexFaces faces_at_;
  PointIndex index_;
  std::vector<Matrix3d> rotation_;
};

void requireSurface(const TriangleMesh& source, const Points& deformed) {
  require(deformed.rows() == source.vertices.rows(), "applyDeformation: one place a vertex");
  require(source.vertices.rows() > 0, "applyDeformation: no vertices");
  requireMesh(source);
}

}  // namespace

Points applyDeformation(const TriangleMesh& source, const Points& deformed, const Points& points) {
  requireSurface(source, deformed);
  const FrameBlend blend(source, deformed);
  const double scale = medianEdgeRatio(source, deformed);
  Points moved(points.rows(), 3);
  blend.forEach(points, [&](int i, const std::vector<FrameBlend::Share>& shares) {
    Vector3d sum = Vector3d::Zero();
    double weight = 0;
    for (const auto& [v, from, share] : shares) {
      sum += share * (deformed.row(v).transpose() + scale * (blend.rotation(v) * from));
      weight += share;
    }
    moved.row(i) = (sum / weight).transpose();
  });
  return moved;
}

Points turnDirections(const TriangleMesh& source,
                      const Points& deformed,
                      const Points& points,
                      const Points& directions) {
  requireSurface(source, deformed);
  require(directions.rows() == points.rows(), "turnDirections: one direction a point");
  const FrameBlend blend(source, deformed);
  Points turned(points.rows(), 3);
  blend.forEach(points, [&](int i, const std::vector<FrameBlend::Share>& shares) {
    const Vector3d direction = directions.row(i);
    Vector3d sum = Vector3d::Zero();
    for (const auto& [v, from, share] : shares) sum += share * (blend.rotation(v) * direction);
    turned.row(i) = direction.norm() * sum.normalized().transpose();
  });
  return turned;
}

Points turnedNormals(const DeformedSurface& surface, const PointCloud& cloud) {
  Points normals = cloud.normals;
  std::vector<int> rows;
  for (int i = 0; i < normals.rows(); ++i)
    if (cloud.points.row(i).allFinite() && normals.row(i).allFinite() && normals.row(i).norm() > 0)
      rows.push_back(i);
  if (rows.empty()) return normals;
  const Points turned = turnDirections(surface.rest,
                                       surface.deformed,
                                       cloud.points(rows, Eigen::all),
                                       cloud.normals(rows, Eigen::all));
  normals(rows, Eigen::all) = turned;
  return normals;
}

PointCloud applyDeformation(const DeformedSurface& surface, PointCloud cloud) {
  cloud.normals = turnedNormals(surface, cloud);
  const std::vector<int> seen = finiteRows(cloud.points);
  const Points at_rest = cloud.points(seen, Eigen::all);
  cloud.points(seen, Eigen::all) = applyDeformation(surface.rest, surface.deformed, at_rest);
  return cloud;
}

DeformedSurface joinedSurface(const TriangleMesh& source, const Points& deformed) {
  requireSurface(source, deformed);
  cleanMesh(source);  // refuses what is no surface
  const std::vector<int> first = weld(source.vertices);
  DeformedSurface surface;
  surface.rest.faces = weldedFaces(source.faces, first);
  const std::vector<int> kept =
      compactVerticesByUse(surface.rest.faces, static_cast<int>(source.vertices.rows()));
  surface.rest.vertices = source.vertices(kept, Eigen::all);
  surface.deformed = deformed(kept, Eigen::all);
  return surface;
}

}  // namespace posture
