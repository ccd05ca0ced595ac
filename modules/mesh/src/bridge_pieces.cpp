// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/mesh/bridge_pieces.h>
#include <posture/mesh/connected_parts.h>
#include <posture/mesh/point_index.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
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
      : mesh_(mesh),
        parts_(connectedParts(mesh)),
        rims_(parts_.area.size()),
        boxes_(parts_.area.size()),
        nearest_(parts_.area.size(), NOTHING_NEAR) {
    std::vector<HalfEdge> all;
    std::set<HalfEdge> repeated;  // as where three faces meet
    for (const auto& f : mesh.faces.rowwise())
      for (int k = 0; k < 3; ++k) {
        all.emplace_back(f[k], f[(k + 1) % 3]);
        if (!taken_.insert(all.back()).second) repeated.insert(all.back());
      }
    double length = 0;
    std::size_t edges = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
      const auto [a, b] = all[i];
      if (taken_.count({b, a}) > 0 || repeated.count({a, b}) > 0) continue;
      const int face = static_cast<int>(i / 3), part = parts_.of_face[face];
      rims_[part].push_back({all[i], face});
      boxes_[part].extend(at(a));
      length += distance(a, b);
      ++edges;
    }
    edge_ = edges > 0 ? length / static_cast<double>(edges) : 0;
  }

  Bridges run() {
    double area = 0;
    for (int part = 0; part < static_cast<int>(rims_.size()); ++part) {
      area += parts_.area[part];
      if (part != parts_.largest && !rims_[part].empty()) apart_.push_back(part);
    }
    widest_ = WIDEST_GAP * std::sqrt(area);
    int pieces = 0;
    if (parts_.largest >= 0 && !rims_[parts_.largest].empty()) {
      join(parts_.largest);
      for (int next = nearestPart(); next >= 0; next = nearestPart()) {
        const double gap = std::get<0>(nearest_[next]);
        if (bridge(rims_[next], boxes_[next], std::max(REACH * gap, gap + 2 * edge_))) {
          ++pieces;
          apart_.erase(std::find(apart_.begin(), apart_.end(), next));
          join(next);
        } else {
          nearest_[next] = NOTHING_NEAR;  // until a part is joined that it is near as well
        }
      }
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
  using Box = Eigen::AlignedBox3d;
  using Gap = std::tuple<double, Place>;  // how wide, and where it begins

  static constexpr Gap NOTHING_NEAR{std::numeric_limits<double>::infinity(), {}};

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

  Eigen::Vector3d at(int v) const { return mesh_.vertices.row(v); }
  Place placeOf(int v) const {
    return {mesh_.vertices(v, 0), mesh_.vertices(v, 1), mesh_.vertices(v, 2)};
  }

  double distance(int v, int w) const { return (at(v) - at(w)).norm(); }

  /// Takes a part to the joined ones: others may be nearer to it than to those before.
  void join(int part) {
    joined_.push_back(part);
    const Rim rim(mesh_, rims_[part]);
    for (const int other : apart_) {
      Gap& least = nearest_[other];
      const auto isFar = [&](double d) { return d > std::min(widest_, std::get<0>(least)); };
      if (isFar(boxes_[part].exteriorDistance(boxes_[other]))) continue;
      for (const RimEdge& e : rims_[other]) {
        const int v = e.ends.first;
        if (isFar(boxes_[part].exteriorDistance(at(v)))) continue;
        const double gap = distance(v, rim.vertex[rim.index.nearest(at(v)).index]);
        if (gap <= widest_) least = std::min(least, {gap, placeOf(v)});
      }
    }
  }

  /// To the joined ones; -1: none is near.
  int nearestPart() const {
    int nearest = -1;
    for (const int part : apart_)
      if (nearest_[part] < (nearest < 0 ? NOTHING_NEAR : nearest_[nearest])) nearest = part;
    return nearest;
  }

  /// Along the rims of the joined parts, what may be within reach of what is in the box.
  std::vector<RimEdge> joinedNear(const Box& box, double reach) const {
    std::vector<RimEdge> edges;
    for (const int part : joined_)
      if (boxes_[part].exteriorDistance(box) <= reach)
        std::copy_if(
            rims_[part].begin(),
            rims_[part].end(),
            std::back_inserter(edges),
            [&](const RimEdge& e) { return box.exteriorDistance(at(e.ends.first)) <= reach; });
    return edges;
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
  bool bridge(const std::vector<RimEdge>& piece, const Box& box, double reach) {
    const std::vector<RimEdge> whole = joinedNear(box, reach);
    std::vector<Candidate> candidates;
    addCandidates(piece, Rim(mesh_, whole), reach, candidates);
    addCandidates(whole, Rim(mesh_, piece), reach, candidates);
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
  std::vector<Box> boxes_;                  // around each rim
  std::vector<Gap> nearest_;                // between each part and the joined ones
  std::vector<int> joined_, apart_;
  std::set<HalfEdge> taken_;  // a half-edge belongs to one face
  std::vector<Face> faces_;
  double edge_ = 0;    // mean, along the rims
  double widest_ = 0;  // gap
};

}  // namespace

Bridges bridgePieces(const TriangleMesh& mesh) { return Bridging(mesh).run(); }

}  // namespace posture
