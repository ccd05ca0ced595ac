// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "remesh.h"

#include <posture/core/parallel.h>

#include "edit_mesh.h"
#include <cmath>
#include <cstdlib>
#include <vector>

namespace posture::synthesis {
namespace {

constexpr int MAX_ROUNDS = 24;
constexpr int SETTLING_ROUNDS = 4;
constexpr double TOO_LONG = 4.0 / 3, TOO_SHORT = 4.0 / 5;
constexpr double COUNT_TOLERANCE = 0.02;
constexpr int BLOCK = 64;  // vertices a thread takes at once

class Remesher {
 public:
  Remesher(const TriangleMesh& mesh, const FleshField& field, int vertices)
      : mesh_(mesh), field_(field), vertices_(vertices) {
    wanted_.resize(mesh_.numSlots());
    edge_ = initialEdge(mesh);
    measureWanted();
  }

  TriangleMesh run() {
    int settled = 0;
    for (int round = 0; round < MAX_ROUNDS && settled < SETTLING_ROUNDS; ++round) {
      splitLongEdges();
      collapseShortEdges();
      evenValences();
      relax();
      const double ratio = static_cast<double>(mesh_.numVertices()) / vertices_;
      const bool close = std::abs(ratio - 1) < COUNT_TOLERANCE;
      settled = close ? settled + 1 : 0;
      if (!close) edge_ *= std::sqrt(ratio);
      measureWanted();
    }
    return mesh_.take();
  }

 private:
  /// Edge of so many equilateral triangles of the whole area.
  double initialEdge(const TriangleMesh& mesh) const {
    double area = 0;
    for (Eigen::Index f = 0; f < mesh.faces.rows(); ++f) {
      const Vec3 a = mesh.vertices.row(mesh.faces(f, 0)), b = mesh.vertices.row(mesh.faces(f, 1)),
                 c = mesh.vertices.row(mesh.faces(f, 2));
      area += 0.5 * (b - a).cross(c - a).norm();
    }
    return std::sqrt(area / (2.0 * vertices_) * 4 / std::sqrt(3.0));
  }

  double wantedLength(int a, int b) const { return 0.5 * (wanted_[a] + wanted_[b]); }

  void splitLongEdges() {
    for (const auto& [a, b] : mesh_.edges()) {
      if (mesh_.length(a, b) < TOO_LONG * wantedLength(a, b)) continue;
      mesh_.split(a, b, 0.5 * (mesh_.point(a) + mesh_.point(b)));
      wanted_.push_back(wantedLength(a, b));
    }
  }

  void collapseShortEdges() {
    for (const auto& [a, b] : mesh_.edges()) {
      if (!mesh_.isAlive(a) || !mesh_.isAlive(b)) continue;
      if (mesh_.length(a, b) > TOO_SHORT * wantedLength(a, b)) continue;
      const Vec3 middle = 0.5 * (mesh_.point(a) + mesh_.point(b));
      if (!makesLongEdge(a, middle) && !makesLongEdge(b, middle)) mesh_.collapse(a, b, middle);
    }
  }

  bool makesLongEdge(int v, const Vec3& at) const {
    for (int w : mesh_.neighbours(v))
      if ((mesh_.point(w) - at).norm() > TOO_LONG * wantedLength(v, w)) return true;
    return false;
  }

  void evenValences() {
    for (const auto& [a, b] : mesh_.edges()) {
      const auto [c, d] = mesh_.oppositeCorners(a, b);
      if (c < 0) continue;
      const auto off = [&](int v, int change) { return std::abs(mesh_.valence(v) + change - 6); };
      const int before = off(a, 0) + off(b, 0) + off(c, 0) + off(d, 0);
      const int after = off(a, -1) + off(b, -1) + off(c, 1) + off(d, 1);
      if (after < before) mesh_.flip(a, b);
    }
  }

  /// Each vertex towards the centre of its faces, within the skin; all from the same old places.
  void relax() {
    const int n = mesh_.numSlots();
    std::vector<Vec3> moved(n);
    forEach(n, BLOCK, [&](int v) {
      if (!mesh_.isAlive(v)) return;
      const Vec3 normal = mesh_.areaNormal(v).normalized();
      const Vec3 way = mesh_.areaCentroid(v) - mesh_.point(v);
      moved[v] = field_.project(mesh_.point(v) + way - way.dot(normal) * normal);
    });
    for (int v = 0; v < n; ++v)
      if (mesh_.isAlive(v)) mesh_.move(v, moved[v]);
  }

  void measureWanted() {
    forEach(mesh_.numSlots(), BLOCK, [&](int v) {
      if (mesh_.isAlive(v)) wanted_[v] = field_.edgeLength(mesh_.point(v), edge_);
    });
  }

  EditMesh mesh_;
  const FleshField& field_;
  int vertices_;
  std::vector<double> wanted_;  ///< edge length at each vertex
  double edge_ = 0;
};

}  // namespace

TriangleMesh remesh(const TriangleMesh& mesh, const FleshField& field, int vertices) {
  return Remesher(mesh, field, vertices).run();
}

}  // namespace posture::synthesis
