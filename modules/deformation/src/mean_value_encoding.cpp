// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/error.h>
#include <posture/deformation/mean_value_encoding.h>
#include <posture/mesh/half_edge_mesh.h>
#include <posture/mesh/vertex_neighbors.h>

#include <Eigen/Dense>

#include "mean_value_weights.h"
#include "polygon_frame.h"
#include <algorithm>
#include <optional>
#include <unordered_set>

namespace posture {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

class Encoder {
 public:
  explicit Encoder(const TriangleMesh& mesh)
      : places_(mesh.vertices),
        count_(static_cast<int>(mesh.vertices.rows())),
        neighbors_(mesh.faces, count_) {}

  MeanValueEncoding encode(const TriangleMesh& mesh, bool with_layout) {
    const ManifoldMesh manifold = cutNonManifold(mesh);
    const HalfEdgeMesh half_edges(manifold.mesh.faces,
                                  static_cast<int>(manifold.mesh.vertices.rows()));
    std::vector<char> cut(count_, 0);
    for (std::size_t v = count_; v < manifold.original_vertex.size(); ++v)
      cut[manifold.original_vertex[v]] = 1;
    encoding_.first.assign(1, 0);
    encoding_.offset.resize(count_);
    for (int v = 0; v < count_; ++v) {
      require(neighbors_.begin(v) != neighbors_.end(v), "encodeMeanValues: a vertex in no face");
      std::vector<int> ring;
      if (!cut[v])
        for (int w : half_edges.neighbors(v)) ring.push_back(manifold.original_vertex[w]);
      add(v, std::move(ring));
    }
    if (with_layout) layOut();
    return std::move(encoding_);
  }

 private:
  struct Frame {
    Matrix3d axes;
    double unit;
  };

  Vector3d place(int v) const { return places_.row(v); }

  std::vector<Vector3d> placesOf(const std::vector<int>& vertices) const {
    std::vector<Vector3d> corners;
    corners.reserve(vertices.size());
    for (int v : vertices) corners.push_back(place(v));
    return corners;
  }

  void add(int v, std::vector<int> polygon) {
    std::optional<std::vector<double>> weight;
    if (polygon.size() > 2) weight = meanValueWeights(place(v), placesOf(polygon), false);
    if (!weight) {
      polygon = triangleNear(v);
      weight = meanValueWeights(place(v), placesOf(polygon), true);
      if (!weight) throw InputError("a part of the mesh is too small to compute with");
    }
    const std::vector<Vector3d> corners = placesOf(polygon);
    const PolygonFrame frame(corners);
    Vector3d rest = place(v);
    for (std::size_t k = 0; k < corners.size(); ++k) rest -= (*weight)[k] * corners[k];
    encoding_.offset[v] = rest.dot(frame.normal()) / frame.radius;
    encoding_.corner.insert(encoding_.corner.end(), polygon.begin(), polygon.end());
    encoding_.weight.insert(encoding_.weight.end(), weight->begin(), weight->end());
    encoding_.first.push_back(static_cast<int>(encoding_.corner.size()));
  }

  /// Three vertices near v, out of line.
  std::vector<int> triangleNear(int v) const {
    constexpr double LEAST_HEIGHT = 0.05;  // of the longest side
    std::vector<int> near{v};
    std::unordered_set<int> seen{v};
    for (std::size_t ring_begin = 0;;) {
      const std::size_t ring_end = near.size();
      for (std::size_t i = ring_begin; i < ring_end; ++i)
        for (const int* w = neighbors_.begin(near[i]); w != neighbors_.end(near[i]); ++w)
          if (seen.insert(*w).second) near.push_back(*w);
      const bool grown = near.size() > ring_end;
      ring_begin = ring_end;
      const std::vector<int> others(near.begin() + 1, near.end());
      const auto [triangle, height] = widestTriangle(others);
      if (height > LEAST_HEIGHT || (!grown && height > 0)) return triangle;
      if (!grown) throw InputError("a part of the mesh lies within a line");
    }
  }

  /// A wide triangle of these vertices, and its height over its first side.
  std::pair<std::vector<int>, double> widestTriangle(const std::vector<int>& of) const {
    const auto farthest = [&](const auto& distance) {
      int best = of.front();
      for (int v : of)
        if (distance(v) > FARTHER_BEYOND_ROUNDING * distance(best)) best = v;
      return best;
    };
    Vector3d centroid = Vector3d::Zero();
    for (int v : of) centroid += place(v) / static_cast<double>(of.size());
    const int a = farthest([&](int v) { return (place(v) - centroid).norm(); });
    const int b = farthest([&](int v) { return (place(v) - place(a)).norm(); });
    const double length = (place(b) - place(a)).norm();
    if (!(length > 0)) return {{}, 0};
    const Vector3d along = (place(b) - place(a)) / length;
    const auto off_line = [&](int v) { return along.cross(place(v) - place(a)).norm(); };
    const int c = farthest(off_line);
    constexpr double ROUNDING = 1e-9;
    const double height = off_line(c) / length;
    return {{a, b, c}, height > ROUNDING ? height : 0};
  }

  /// Of a vertex's polygon.
  Frame frameOf(int v) const {
    const std::vector<Vector3d> corners =
        placesOf({encoding_.corner.begin() + encoding_.first[v],
                  encoding_.corner.begin() + encoding_.first[v + 1]});
    const PolygonFrame frame(corners);
    return {polygonAxes(frame, corners), frame.radius};
  }

  void layOut() {
    std::vector<Frame> frames;
    frames.reserve(count_);
    for (int v = 0; v < count_; ++v) frames.push_back(frameOf(v));
    std::vector<char> placed(count_, 0);
    for (int root = 0; root < count_; ++root) {
      if (placed[root]) continue;
      placed[root] = 1;
      std::size_t next = encoding_.layout.size();
      encoding_.layout.push_back({root, -1, Vector3d::Zero(), Eigen::Quaterniond::Identity(), 1});
      for (; next < encoding_.layout.size(); ++next) {
        const int u = encoding_.layout[next].vertex;
        for (const int* w = neighbors_.begin(u); w != neighbors_.end(u); ++w) {
          if (placed[*w]) continue;
          placed[*w] = 1;
          const Frame &from = frames[u], &to = frames[*w];
          encoding_.layout.push_back(
              {*w,
               u,
               from.axes.transpose() * (place(*w) - place(u)) / from.unit,
               Eigen::Quaterniond(Matrix3d(from.axes.transpose() * to.axes)).normalized(),
               to.unit / from.unit});
        }
      }
    }
  }

  const Points& places_;
  int count_;
  VertexNeighbors neighbors_;
  MeanValueEncoding encoding_;
};

}  // namespace

MeanValueEncoding encodeMeanValues(const TriangleMesh& mesh, bool with_layout) {
  return Encoder(mesh).encode(mesh, with_layout);
}

MeanValueResidual meanValueResidual(const MeanValueEncoding& encoding,
                                    int i,
                                    const Vector3d& place,
                                    const std::vector<Vector3d>& corners,
                                    bool with_jacobian) {
  const PolygonFrame frame(corners);
  const double* weight = encoding.weight.data() + encoding.first[i];
  const double offset = encoding.offset[i], area = frame.area.norm();
  // A collapsed polygon has no normal: the offset then points nowhere.
  const Vector3d normal = area > 0 ? Vector3d(frame.area / area) : Vector3d::Zero();
  const std::size_t count = corners.size();
  MeanValueResidual residual;
  residual.value = place - offset * frame.radius * normal;
  for (std::size_t k = 0; k < count; ++k) residual.value -= weight[k] * corners[k];
  if (!with_jacobian) return residual;
  residual.by_corner.resize(count);
  const Matrix3d across =
      area > 0 ? Matrix3d((Matrix3d::Identity() - normal * normal.transpose()) / area)
               : Matrix3d::Zero();
  for (std::size_t k = 0; k < count; ++k) {
    const Vector3d diagonal = 0.5 * (corners[(k + count - 1) % count] - corners[(k + 1) % count]);
    Matrix3d area_by_corner;  // the cross product with the diagonal
    area_by_corner << 0, -diagonal.z(), diagonal.y(), diagonal.z(), 0, -diagonal.x(), -diagonal.y(),
        diagonal.x(), 0;
    const Vector3d radius_by_corner =
        frame.radius > 0
            ? Vector3d((corners[k] - frame.centroid) / (static_cast<double>(count) * frame.radius))
            : Vector3d::Zero();
    residual.by_corner[k] =
        -weight[k] * Matrix3d::Identity() -
        offset * (normal * radius_by_corner.transpose() + frame.radius * across * area_by_corner);
  }
  return residual;
}

}  // namespace posture
