// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/matrix_of.h>
#include <posture/mesh/areas.h>
#include <posture/mesh/edges.h>
#include <posture/mesh/half_edge_mesh.h>
#include <posture/mesh/hole_patches.h>

#include <Eigen/Geometry>
#include <Eigen/SparseCholesky>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

namespace posture {
namespace {

using Eigen::RowVector3d;

/// A disc in rings from the rim inwards: vertices 0 to k - 1 are the rim, counter-clockwise.
struct Disc {
  int vertices = 0;
  std::vector<std::array<int, 3>> faces;
};

/// Faces between a ring and the next one inside, both from angle 0 on.
void joinRings(const std::vector<double>& outer,
               int first_outer,
               const std::vector<double>& inner,
               int first_inner,
               std::vector<std::array<int, 3>>& faces) {
  const int a = static_cast<int>(outer.size()), b = static_cast<int>(inner.size());
  const auto after = [](const std::vector<double>& ring, int i) {
    return i + 1 < static_cast<int>(ring.size()) ? ring[i + 1] : 2 * M_PI;
  };
  int i = 0, j = 0;
  while (i < a || j < b) {
    const int p = first_outer + i % a, q = first_inner + j % b;
    if (j == b || (i < a && after(outer, i) <= after(inner, j))) {
      faces.push_back({p, first_outer + (i + 1) % a, q});
      ++i;
    } else {
      faces.push_back({p, first_inner + (j + 1) % b, q});
      ++j;
    }
  }
}

Disc discFor(const std::vector<double>& rim_angles, int rings) {
  const int k = static_cast<int>(rim_angles.size());
  Disc disc;
  disc.vertices = k;
  std::vector<double> outer = rim_angles;
  int first_outer = 0;
  for (int ring = 1; ring < rings; ++ring) {
    const int count = static_cast<int>(std::lround(2 * M_PI * (rings - ring)));
    std::vector<double> inner(count);
    for (int i = 0; i < count; ++i) inner[i] = 2 * M_PI * i / count;
    joinRings(outer, first_outer, inner, disc.vertices, disc.faces);
    first_outer = disc.vertices;
    disc.vertices += count;
    outer = std::move(inner);
  }
  const int m = static_cast<int>(outer.size());
  if (m == 3) {
    disc.faces.push_back({first_outer, first_outer + 1, first_outer + 2});
    return disc;
  }
  for (int i = 0; i < m; ++i)
    disc.faces.push_back({first_outer + i, first_outer + (i + 1) % m, disc.vertices});
  ++disc.vertices;
  return disc;
}

/// A hole with its patch.
class Patch {
 public:
  /// A soap film in the rim.
  Patch(const TriangleMesh& mesh, const HalfEdgeMesh& half_edges, const std::vector<int>& hole)
      : mesh_(mesh), half_edges_(half_edges), hole_(hole), k_(static_cast<int>(hole.size())) {
    // Seen from the hole the rim runs the other way.
    std::vector<double> angles;
    for (int i = 0; i < k_; ++i) {
      rim_.push_back(half_edges.target(hole[k_ - 1 - i]));
      angles.push_back(rim_length_);
      rim_length_ += edge(i).norm();
    }
    for (double& angle : angles) angle *= 2 * M_PI / std::max(rim_length_, 1e-300);
    disc_ = discFor(angles, ringCount());
    places_ = Points::Zero(disc_.vertices, 3);
    for (int i = 0; i < k_; ++i) places_.row(i) = mesh.vertices.row(rim_[i]);
    solve(false);
  }

  /// Mean cosine, along the rim, of the angle between the film and the surface around it.
  double smoothness() const {
    double sum = 0;
    for (const auto& face : disc_.faces)
      for (int c = 0; c < 3; ++c) {
        const int i = face[c], j = face[(c + 1) % 3];
        if (i >= k_ || j != (i + 1) % k_) continue;
        const RowVector3d film = unitOrZero(
            areaVector(places_.row(face[0]), places_.row(face[1]), places_.row(face[2])));
        sum += edge(i).norm() * film.dot(normalBeside(i));
      }
    return rim_length_ > 0 ? sum / rim_length_ : -1;
  }

  /// Goes on from the surface as smoothly as it can; stays a film where that overshoots, as beside
  /// long thin faces.
  void goOnSmoothly() {
    const Points film = places_;
    solve(true);
    double area = 0, film_area = 0, turned = 0;
    for (const auto& [a, b, c] : disc_.faces) {
      const RowVector3d was = areaVector(film.row(a), film.row(b), film.row(c)),
                        is = areaVector(places_.row(a), places_.row(b), places_.row(c));
      area += is.norm();
      film_area += was.norm();
      if (is.dot(was) < 0) turned += is.norm();
    }
    constexpr double MOST_GROWTH = 3, MOST_TURNED = 0.25;
    if (!(area < MOST_GROWTH * film_area) || turned > MOST_TURNED * area) places_ = film;
  }

  double rimLength() const { return rim_length_; }

  /// The new vertices.
  std::size_t size() const { return static_cast<std::size_t>(disc_.vertices - k_); }
  Points vertices() const { return places_.bottomRows(disc_.vertices - k_); }

  /// Faces between vertices on the rim and new ones.
  const std::vector<std::array<int, 3>>& faces() const { return disc_.faces; }
  bool isOnRim(int v) const { return v < k_; }
  int rim(int v) const { return rim_[v]; }   ///< as a vertex of the mesh
  int rowOf(int v) const { return v - k_; }  ///< of vertices()

 private:
  RowVector3d edge(int i) const {
    const int h = hole_[k_ - 1 - i];
    return mesh_.vertices.row(half_edges_.origin(h)) - mesh_.vertices.row(half_edges_.target(h));
  }

  /// Normal, as long as twice the area.
  static RowVector3d areaVector(const RowVector3d& a, const RowVector3d& b, const RowVector3d& c) {
    return (b - a).cross(c - a);
  }

  static RowVector3d unitOrZero(const RowVector3d& v) {
    const double length = v.norm();
    return length > 0 ? RowVector3d(v / length) : RowVector3d(0, 0, 0);
  }

  /// As in a circle of k edges.
  int ringCount() const {
    // The borders of fine sheets have thousands of edges.
    constexpr double MOST = 64;
    return static_cast<int>(std::lround(std::min(k_ / (2 * M_PI), MOST)));
  }

  /// Of the surface at edge i of the rim: its faces at both ends, by area. One face is mostly
  /// noise.
  RowVector3d normalBeside(int i) const {
    RowVector3d sum = RowVector3d::Zero();
    for (int v : {rim_[i], rim_[(i + 1) % k_]})
      for (int h : half_edges_.star(v)) {
        const auto at = [&](int g) { return mesh_.vertices.row(half_edges_.origin(g)); };
        sum += areaVector(at(h), at(HalfEdgeMesh::next(h)), at(HalfEdgeMesh::previous(h)));
      }
    return unitOrZero(sum);
  }

  /// Umbrellas (a vertex less the mean of its neighbours) of the new vertices vanish; or those of
  /// the rim as well, which know the surface around, are least in square.
  void solve(bool with_rim) {
    const int unknowns = disc_.vertices - k_;
    if (unknowns == 0) return;
    std::vector<std::set<int>> neighbors(disc_.vertices);
    for (const auto& face : disc_.faces)
      for (int c = 0; c < 3; ++c) {
        neighbors[face[c]].insert(face[(c + 1) % 3]);
        neighbors[face[(c + 1) % 3]].insert(face[c]);
      }
    std::vector<Eigen::Triplet<double>> entries;
    std::vector<RowVector3d> right;
    for (int v = with_rim ? 0 : k_; v < disc_.vertices; ++v) {
      const int row = static_cast<int>(right.size());
      std::vector<int> around;  // of the mesh, but for the rim's own edges
      if (v < k_)
        for (int w : half_edges_.neighbors(rim_[v]))
          if (w != rim_[(v + 1) % k_] && w != rim_[(v + k_ - 1) % k_]) around.push_back(w);
      const double share = 1.0 / static_cast<double>(neighbors[v].size() + around.size());
      RowVector3d known = RowVector3d::Zero();
      for (int w : around) known += share * mesh_.vertices.row(w);
      const auto add = [&](int w, double factor) {
        if (w < k_)
          known += factor * places_.row(w);
        else
          entries.emplace_back(row, w - k_, factor);
      };
      for (int w : neighbors[v]) add(w, share);
      add(v, -1);
      right.emplace_back(-known);
    }
    Eigen::SparseMatrix<double> umbrellas(static_cast<Eigen::Index>(right.size()), unknowns);
    umbrellas.setFromTriplets(entries.begin(), entries.end());
    const auto given = matrixOf<Eigen::MatrixXd>(right);
    const Eigen::SparseMatrix<double> normal = umbrellas.transpose() * umbrellas;
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(normal);
    if (solver.info() == Eigen::Success)
      places_.bottomRows(unknowns) = solver.solve(umbrellas.transpose() * given);
  }

  const TriangleMesh& mesh_;
  const HalfEdgeMesh& half_edges_;
  const std::vector<int>& hole_;
  int k_;
  double rim_length_ = 0;
  std::vector<int> rim_;  // counter-clockwise, seen from outside
  Disc disc_;
  Points places_;
};

}  // namespace

HolePatches patchHoles(const TriangleMesh& mesh) {
  constexpr double SHORT = 0.5, LEAST_SMOOTHNESS = 0.25;
  const ManifoldMesh cut = cutNonManifold(mesh);
  const auto copies = static_cast<int>(cut.mesh.vertices.rows());
  const auto n = static_cast<int>(mesh.vertices.rows());
  const HalfEdgeMesh half_edges(cut.mesh.faces, copies);
  const double short_rim = SHORT * rootArea(mesh);
  std::set<std::pair<int, int>> border;  // other cuts are no holes
  for (const Edge& e : meshEdges(mesh.faces))
    if (e.faces == 1) border.emplace(e.first, e.second);
  const auto isBorder = [&](int h) {
    return border.count(std::minmax(cut.original_vertex[half_edges.origin(h)],
                                    cut.original_vertex[half_edges.target(h)])) > 0;
  };
  HolePatches patches;
  std::vector<RowVector3d> vertices;
  std::vector<std::array<int, 3>> faces;
  for (const std::vector<int>& hole : half_edges.boundaryLoops()) {
    if (hole.size() < 3 || !std::all_of(hole.begin(), hole.end(), isBorder)) continue;
    Patch patch(cut.mesh, half_edges, hole);
    if (patch.rimLength() > short_rim && patch.smoothness() < LEAST_SMOOTHNESS) continue;
    // Cracks everywhere: closing them would double the mesh.
    if (vertices.size() + patch.size() > static_cast<std::size_t>(n)) continue;
    patch.goOnSmoothly();
    const auto first = n + static_cast<int>(vertices.size());
    const Points inside = patch.vertices();
    for (const auto& vertex : inside.rowwise()) vertices.emplace_back(vertex);
    for (const std::array<int, 3>& face : patch.faces()) {
      faces.emplace_back();
      for (int c = 0; c < 3; ++c)
        faces.back()[c] = patch.isOnRim(face[c]) ? cut.original_vertex[patch.rim(face[c])]
                                                 : first + patch.rowOf(face[c]);
    }
    ++patches.holes;
    patches.rim_length += patch.rimLength();
  }
  patches.vertices = matrixOf<Points>(vertices);
  patches.faces = matrixOf<Faces>(faces);
  return patches;
}

}  // namespace posture
