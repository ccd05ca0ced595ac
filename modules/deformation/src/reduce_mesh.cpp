// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/deformation/collapse.h>
#include <posture/deformation/reduce_mesh.h>
#include <posture/geodesic/landmarks.h>
#include <posture/mesh/clean_mesh.h>
#include <posture/mesh/half_edge_mesh.h>
#include <posture/mesh/point_index.h>

#include <Eigen/Geometry>

#include <cmath>
#include <memory>
#include <numeric>

namespace posture {
namespace {

using Eigen::Vector3d;

class Flipper {
 public:
  explicit Flipper(const ManifoldMesh& manifold)
      : places_(manifold.mesh.vertices),
        mesh_(manifold.mesh.faces, static_cast<int>(places_.rows())) {}

  Faces run() {
    std::vector<int> open(mesh_.halfEdgeCount());
    std::iota(open.begin(), open.end(), 0);
    // In the plane every flip brings the mesh nearer to Delaunay; on a curved surface only nearly
    // so, hence the bound.
    long long flips_left = 10LL * mesh_.halfEdgeCount();
    while (!open.empty() && flips_left > 0) {
      const int h = open.back();
      open.pop_back();
      if (mesh_.twin(h) < 0 || !isBad(h) || !mesh_.canFlip(h)) continue;
      const int t = mesh_.twin(h);
      mesh_.flip(h);
      --flips_left;
      for (int g : {HalfEdgeMesh::next(h),
                    HalfEdgeMesh::previous(h),
                    HalfEdgeMesh::next(t),
                    HalfEdgeMesh::previous(t)})
        open.push_back(g);
    }
    return mesh_.faces();
  }

 private:
  Vector3d place(int v) const { return places_.row(v); }
  Vector3d normal(int a, int b, int c) const {
    return (place(b) - place(a)).cross(place(c) - place(a)).normalized();
  }
  double angle(int at, int a, int b) const {
    const Vector3d u = place(a) - place(at), v = place(b) - place(at);
    return std::atan2(u.cross(v).norm(), u.dot(v));
  }

  bool isBad(int h) const {
    const int t = mesh_.twin(h);
    const int a = mesh_.origin(h), b = mesh_.origin(t), c = mesh_.origin(HalfEdgeMesh::previous(h)),
              d = mesh_.origin(HalfEdgeMesh::previous(t));
    if (angle(c, a, b) + angle(d, a, b) < M_PI + 1e-6) return false;
    // After the flip the surface must not fold: within 60 degrees of how it lay.
    const Vector3d before = (normal(a, b, c) + normal(b, a, d)).normalized();
    constexpr double LEAST_COSINE = 0.5;
    return before.dot(normal(d, c, a)) > LEAST_COSINE && before.dot(normal(c, d, b)) > LEAST_COSINE;
  }

  const Points& places_;
  HalfEdgeMesh mesh_;
};

Points verticesOf(const TriangleMesh& mesh, const std::vector<int>& which) {
  Points places(which.size(), 3);
  for (std::size_t i = 0; i < which.size(); ++i) places.row(i) = mesh.vertices.row(which[i]);
  return places;
}

}  // namespace

Faces delaunayFlips(const TriangleMesh& mesh) {
  const ManifoldMesh manifold = cutNonManifold(mesh);
  Faces faces = Flipper(manifold).run();
  for (int i = 0; i < faces.size(); ++i)
    faces.data()[i] = manifold.original_vertex[faces.data()[i]];
  return faces;
}

ReducedMesh reduceMesh(const TriangleMesh& mesh, int count) {
  const int n = static_cast<int>(mesh.vertices.rows());
  const Landmarks samples = voronoiSamples(mesh, FastMarching(mesh), count, 0);
  const std::vector<int>& spread = samples.vertices;
  TriangleMesh reduced = mesh;
  if (count < n) {
    std::vector<char> keep(n, 0);
    for (int v : spread) keep[v] = 1;
    reduced.faces = collapseToVertices(mesh, keep);
    reduced.faces = delaunayFlips(reduced);
  }
  // What the collapse had to cut off goes.
  const CleanMesh connected = cleanMesh(reduced, Facing::AS_MOST);
  std::vector<char> stays(n, 0);
  for (int v : connected.input_vertex) stays[v] = 1;
  ReducedMesh result;
  std::vector<int> number(n, -1);
  const auto take = [&](int v) {
    number[v] = static_cast<int>(result.vertex.size());
    result.vertex.push_back(v);
  };
  for (int v : spread)
    if (stays[v]) take(v);
  // Of several vertices at one place cleaning keeps the first, which need not be the sample.
  for (int v : connected.input_vertex)
    if (number[v] < 0) take(v);
  result.nearest.resize(n);
  std::unique_ptr<PointIndex> index;  // needed where a sample was cut off, or no sample reaches
  for (int v = 0; v < n; ++v) {
    const int sample = samples.nearest[v];
    result.nearest[v] = sample >= 0 ? number[spread[sample]] : -1;
    if (result.nearest[v] >= 0) continue;
    if (!index) index = std::make_unique<PointIndex>(verticesOf(mesh, result.vertex));
    result.nearest[v] = index->nearest(mesh.vertices.row(v)).index;
  }
  result.mesh.vertices = verticesOf(mesh, result.vertex);
  result.mesh.faces = connected.mesh.faces;
  for (int i = 0; i < result.mesh.faces.size(); ++i) {
    int& corner = result.mesh.faces.data()[i];
    corner = number[connected.input_vertex[corner]];
  }
  return result;
}

}  // namespace posture
