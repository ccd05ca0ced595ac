// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/mesh/bridge_pieces.h>
#include <posture/mesh/connected_parts.h>
#include <posture/mesh/edges.h>
#include <posture/mesh/point_index.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

namespace posture {
namespace {

/// Of the square root of the area. A wider gap may hide anything.
constexpr double WIDEST_GAP = 0.05;

/// The faces of a strip are at most so many times as long as the gap is wide, or two edges longer.
constexpr double REACH = 2;

/// Cosine between a face and the one it goes on from: a surface does not turn back in a gap.
constexpr double LEAST_AGREEMENT = 0.1;

using HalfEdge = std::pair<int, int>;  // from, to

struct RimEdge {
  HalfEdge ends;
  int face;
};

class Bridging {
 public:
  explicit Bridging(const TriangleMesh& mesh)
      : mesh_(mesh), parts_(connectedParts(mesh)), rims_(parts_.area.size()) {
    std::vector<HalfEdge> all;
    for (const auto& f : mesh.faces.rowwise())
      for (int k = 0; k < 3; ++k) all.emplace_back(f[k], f[(k + 1) % 3]);
    taken_.insert(all.begin(), all.end());
    double length = 0;
    std::size_t edges = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
      const auto [a, b] = all[i];
      if (taken_.count({b, a}) > 0) continue;
      const int face = static_cast<int>(i / 3);
      rims_[parts_.of_face[face]].push_back({all[i], face});
      length += (mesh.vertices.row(a) - mesh.vertices.row(b)).norm();
      ++edges;
    }
    edge_ = edges > 0 ? length / static_cast<double>(edges) : 0;
  }

  Bridges run() {
    std::vector<int> apart;
    double area = 0;
    for (int part = 0; part < static_cast<int>(rims_.size()); ++part) {
      area += parts_.area[part];
      if (part != parts_.largest && !rims_[part].empty()) apart.push_back(part);
    }
    if (parts_.largest >= 0) joined_ = rims_[parts_.largest];
    int pieces = 0;
    while (!joined_.empty() && !apart.empty()) {
      const Rim whole(mesh_, joined_);
      const auto [gap, next] = nearestOf(apart, whole);
      if (gap > WIDEST_GAP * std::sqrt(area)) break;
      pieces += bridge(whole, rims_[next], std::max(REACH * gap, gap + 2 * edge_));
      joined_.insert(joined_.end(), rims_[next].begin(), rims_[next].end());
      apart.erase(std::find(apart.begin(), apart.end(), next));
    }
    Bridges bridges;
    bridges.pieces = pieces;
    bridges.faces.resize(static_cast<Eigen::Index>(faces_.size()), 3);
    for (std::size_t f = 0; f < faces_.size(); ++f)
      bridges.faces.row(static_cast<Eigen::Index>(f)) << faces_[f][0], faces_[f][1], faces_[f][2];
    return bridges;
  }

 private:
  using Face = std::array<int, 3>;
  using Place = std::array<double, 3>;

  /// The vertices along some rims, to look for neighbours among.
  struct Rim {
    Rim(const TriangleMesh& mesh, const std::vector<RimEdge>& edges)
        : vertex(verticesOf(edges)), index(mesh.vertices(vertex, Eigen::all)) {}

    static std::vector<int> verticesOf(const std::vector<RimEdge>& edges) {
      std::vector<int> vertices;
      for (const RimEdge& e : edges) vertices.push_back(e.ends.first);
      std::sort(vertices.begin(), vertices.end());
      vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
      return vertices;
    }

    std::vector<int> vertex;
    PointIndex index;
  };

  Place placeOf(int v) const {
    return {mesh_.vertices(v, 0), mesh_.vertices(v, 1), mesh_.vertices(v, 2)};
  }

  double distance(int v, int w) const {
    return (mesh_.vertices.row(v) - mesh_.vertices.row(w)).norm();
  }

  std::pair<double, int> nearestOf(const std::vector<int>& apart, const Rim& whole) const {
    std::tuple<double, Place, int> best{std::numeric_limits<double>::infinity(), {}, -1};
    for (const int part : apart)
      for (const RimEdge& e : rims_[part]) {
        const int v = e.ends.first;
        const double gap = whole.index.nearest(mesh_.vertices.row(v).transpose()).distance;
        best = std::min(best, {gap, placeOf(v), part});
      }
    return {std::get<0>(best), std::get<2>(best)};
  }

  /// An edge of one rim and a vertex of the other, with how long the face they make would be.
  struct Candidate {
    double length;
    std::array<Place, 3> places;
    Face face;

    bool operator<(const Candidate& other) const {
      return std::tie(length, places) < std::tie(other.length, other.places);
    }
  };

  /// Whether a face looks the way the one it would be joined to along an edge does.
  bool agrees(const Face& face, int beyond) const {
    const auto normal = [&](const auto& f) -> Eigen::Vector3d {
      const Eigen::Vector3d a = mesh_.vertices.row(f[0]), b = mesh_.vertices.row(f[1]),
                            c = mesh_.vertices.row(f[2]);
      return (b - a).cross(c - a).normalized();
    };
    return normal(face).dot(normal(mesh_.faces.row(beyond))) > LEAST_AGREEMENT;
  }

  void addCandidates(const std::vector<RimEdge>& edges,
                     const Rim& across,
                     double reach,
                     std::vector<Candidate>& candidates) const {
    for (const auto& [ends, beyond] : edges) {
      const auto [a, b] = ends;
      for (const int i : across.index.within(mesh_.vertices.row(a).transpose(), reach)) {
        const int q = across.vertex[i];
        const double length = std::max(distance(a, q), distance(b, q));
        // Seen from the gap the rim runs the other way.
        if (length <= reach && agrees({b, a, q}, beyond))
          candidates.push_back({length, {placeOf(b), placeOf(a), placeOf(q)}, {b, a, q}});
      }
    }
  }

  bool isFree(const Face& face) const {
    for (int k = 0; k < 3; ++k)
      if (taken_.count({face[k], face[(k + 1) % 3]}) > 0) return false;
    return true;
  }

  /// Whether any face was put between the two; the shortest are put first.
  bool bridge(const Rim& whole, const std::vector<RimEdge>& piece, double reach) {
    std::vector<Candidate> candidates;
    addCandidates(piece, whole, reach, candidates);
    addCandidates(joined_, Rim(mesh_, piece), reach, candidates);
    std::sort(candidates.begin(), candidates.end());
    const std::size_t before = faces_.size();
    for (const Candidate& candidate : candidates) {
      if (!isFree(candidate.face)) continue;
      for (int k = 0; k < 3; ++k) taken_.emplace(candidate.face[k], candidate.face[(k + 1) % 3]);
      faces_.push_back(candidate.face);
    }
    return faces_.size() > before;
  }

  const TriangleMesh& mesh_;
  const ConnectedParts parts_;
  std::vector<std::vector<RimEdge>> rims_;  // by part
  std::vector<RimEdge> joined_;
  std::set<HalfEdge> taken_;  // a half-edge belongs to one face
  std::vector<Face> faces_;
  double edge_ = 0;  // mean, along the rims
};

}  // namespace

Bridges bridgePieces(const TriangleMesh& mesh) { return Bridging(mesh).run(); }

}  // namespace posture
