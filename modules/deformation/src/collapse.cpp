// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/error.h>
#include <posture/deformation/collapse.h>
#include <posture/mesh/half_edge_mesh.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <queue>
#include <tuple>

namespace posture {
namespace {

using Eigen::Vector3d;

/// A half-edge collapse waiting its turn; void once `version` is out of date.
struct Collapse {
  double cost;
  double length_sq;
  int from;
  int into;
  int version;

  auto key() const { return std::tie(cost, length_sq, from, into); }
  bool operator<(const Collapse& that) const { return key() > that.key(); }  // least on top
};

class Collapser {
 public:
  Collapser(const ManifoldMesh& input, const std::vector<char>& keep)
      : vertices_(input.mesh.vertices),
        mesh_(input.mesh.faces, static_cast<int>(vertices_.rows())),
        keep_(vertices_.rows()),
        version_(vertices_.rows(), 0) {
    for (std::size_t v = 0; v < keep_.size(); ++v) keep_[v] = keep[input.original_vertex[v]];
  }

  Faces run() {
    for (const bool allow_flips : {false, true}) {
      allow_flips_ = allow_flips;
      queue_ = {};
      for (int v = 0; v < mesh_.vertexCount(); ++v) enqueue(v);
      while (!queue_.empty()) {
        const Collapse next = queue_.top();
        queue_.pop();
        if (next.version != version_[next.from]) continue;
        if (isAllowed(next.from, next.into))
          apply(next);
        else
          enqueue(next.from, &next);
      }
    }
    return keptFaces();
  }

 private:
  Vector3d place(int v) const { return vertices_.row(v).transpose(); }

  /// Queues the cheapest collapse of v, or the cheapest one after `refused`. Whether a collapse is
  /// allowed is asked only when its turn comes: that is the dearer question.
  void enqueue(int v, const Collapse* refused = nullptr) {
    if (keep_[v] || mesh_.outgoing(v) < 0) return;
    const std::vector<int> star = mesh_.star(v);
    bool found = false;
    Collapse best{};
    for (int into : mesh_.neighbors(v)) {
      const double length_sq = (place(into) - place(v)).squaredNorm();
      const Collapse c{cost(star, into), length_sq, v, into, version_[v]};
      if (refused != nullptr && !(c < *refused)) continue;
      if (!found || best < c) best = c;
      found = true;
    }
    if (found) queue_.push(best);
  }

  /// Change of volume, squared and summed face by face.
  double cost(const std::vector<int>& star, int into) const {
    const int v = mesh_.origin(star.front());
    const Vector3d from = place(v), shift = place(into) - from;
    double sum = 0;
    for (int h : star) {
      const Vector3d a = place(mesh_.target(h)) - from;
      const Vector3d b = place(mesh_.origin(HalfEdgeMesh::previous(h))) - from;
      const double volume = shift.dot(a.cross(b)) / 6;
      sum += volume * volume;
    }
    if (mesh_.isBoundaryVertex(v)) {
      const Vector3d first = place(mesh_.target(star.front())) - from;
      const Vector3d last = place(mesh_.origin(HalfEdgeMesh::previous(star.back()))) - from;
      const double area_sq =
          (first.cross(shift).squaredNorm() + last.cross(shift).squaredNorm()) / 4;
      sum += shift.squaredNorm() * area_sq;
    }
    return sum;
  }

  bool isAllowed(int from, int into) const {
    return (allow_flips_ || !flipsFace(from, into)) && mesh_.canCollapse(from, into);
  }

  bool flipsFace(int from, int into) const {
    for (int h : mesh_.star(from)) {
      const int a = mesh_.target(h), b = mesh_.origin(HalfEdgeMesh::previous(h));
      if (a == into || b == into) continue;
      const Vector3d side = place(b) - place(a);
      const Vector3d before = side.cross(place(from) - place(a));
      const Vector3d after = side.cross(place(into) - place(a));
      if (!(before.dot(after) > 0)) return true;
    }
    return false;
  }

  void apply(const Collapse& collapse) {
    std::vector<int> changed = mesh_.neighbors(collapse.from);
    mesh_.collapse(collapse.from, collapse.into);
    for (int v : changed) {
      ++version_[v];
      enqueue(v);
    }
  }

  Faces keptFaces() const {
    const Faces live = mesh_.faces();
    Faces kept(live.rows(), 3);
    int count = 0;
    for (int f = 0; f < live.rows(); ++f)
      if (keep_[live(f, 0)] && keep_[live(f, 1)] && keep_[live(f, 2)])
        kept.row(count++) = live.row(f);
    return kept.topRows(count);
  }

  const Points& vertices_;
  HalfEdgeMesh mesh_;
  std::vector<char> keep_;
  std::vector<int> version_;
  std::priority_queue<Collapse> queue_;
  bool allow_flips_ = false;
};

}  // namespace

Faces collapseToVertices(const TriangleMesh& mesh, const std::vector<char>& keep) {
  require(static_cast<Eigen::Index>(keep.size()) == mesh.vertices.rows(),
          "collapseToVertices: one flag a vertex");
  const ManifoldMesh manifold = cutNonManifold(mesh);
  Faces faces = Collapser(manifold, keep).run();
  // Copies of one vertex may have come to be corners of one face.
  int count = 0;
  for (int f = 0; f < faces.rows(); ++f) {
    const int a = manifold.original_vertex[faces(f, 0)], b = manifold.original_vertex[faces(f, 1)],
              c = manifold.original_vertex[faces(f, 2)];
    if (a != b && b != c && c != a) faces.row(count++) << a, b, c;
  }
  return faces.topRows(count);
}

}  // namespace posture
