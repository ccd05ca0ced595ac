// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/matrix_of.h>
#include <posture/mesh/split_long_edges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <queue>
#include <tuple>
#include <utility>

namespace posture {
namespace {

using Eigen::RowVector3d;

class Splitter {
 public:
  explicit Splitter(const TriangleMesh& mesh) {
    for (const auto& place : mesh.vertices.rowwise()) places_.emplace_back(place);
    for (int f = 0; f < mesh.faces.rows(); ++f) {
      faces_.push_back({mesh.faces(f, 0), mesh.faces(f, 1), mesh.faces(f, 2)});
      parts_.push_back({f});
      for (int k = 0; k < 3; ++k) {
        const auto [entry, is_new] =
            beside_.try_emplace(ends(faces_[f][k], faces_[f][(k + 1) % 3]));
        entry->second.push_back(f);
        if (is_new) offer(entry->first);
      }
    }
  }

  void run(std::size_t count) {
    while (places_.size() < count && !open_.empty()) {
      const Ends edge = open_.top().edge;
      open_.pop();
      if (mayBeSplit(edge)) split(edge);
    }
  }

  SplitMesh result() const {
    return {{matrixOf<Points>(places_), matrixOf<Faces>(faces_)}, parts_};
  }

 private:
  using Ends = std::pair<int, int>;  // the smaller number first
  using Place = std::array<double, 3>;

  struct Open {
    double length;
    Place middle, end;  // of edges of equal length, those that come first
    Ends edge;

    bool operator<(const Open& other) const {
      if (length != other.length) return length < other.length;
      return std::tie(middle, end, edge) > std::tie(other.middle, other.end, other.edge);
    }
  };

  static Ends ends(int a, int b) { return std::minmax(a, b); }
  static Place ordered(const RowVector3d& p) { return {p[0], p[1], p[2]}; }
  RowVector3d middle(const Ends& e) const { return (places_[e.first] + places_[e.second]) / 2; }

  void offer(const Ends& e) {
    const RowVector3d a = places_[e.first], b = places_[e.second];
    open_.push({(a - b).squaredNorm(), ordered(middle(e)), std::min(ordered(a), ordered(b)), e});
  }

  static int cornerOf(const std::array<int, 3>& face, int v) {
    return static_cast<int>(std::find(face.begin(), face.end(), v) - face.begin());
  }

  bool mayBeSplit(const Ends& edge) const {
    const RowVector3d at = middle(edge);
    if (at == places_[edge.first] || at == places_[edge.second]) return false;
    const std::vector<int>& faces = beside_.at(edge);
    return std::none_of(faces.begin(), faces.end(), [&](int f) {
      return std::any_of(
          faces_[f].begin(), faces_[f].end(), [&](int v) { return places_[v] == at; });
    });
  }

  /// Each face beside the edge keeps the half at the first end; the other half is a new face.
  void split(const Ends& edge) {
    const auto [a, b] = edge;
    const int m = static_cast<int>(places_.size());
    places_.push_back(middle(edge));
    const std::vector<int> faces = std::move(beside_.at(edge));
    beside_.erase(edge);
    std::vector<int>&at_a = beside_[ends(a, m)], &at_b = beside_[ends(b, m)];
    for (const int f : faces) {
      const int half = static_cast<int>(faces_.size());
      const int ka = cornerOf(faces_[f], a), kb = cornerOf(faces_[f], b), kc = 3 - ka - kb;
      const int c = faces_[f][kc];
      const Eigen::Vector3d in_face = (parts_[f].corners.col(ka) + parts_[f].corners.col(kb)) / 2;
      faces_.push_back(faces_[f]);
      parts_.push_back(parts_[f]);
      faces_[f][kb] = m;
      parts_[f].corners.col(kb) = in_face;
      faces_[half][ka] = m;
      parts_[half].corners.col(ka) = in_face;
      at_a.push_back(f);
      at_b.push_back(half);
      std::vector<int>& far = beside_.at(ends(b, c));
      std::replace(far.begin(), far.end(), f, half);
      std::vector<int>& across = beside_[ends(c, m)];
      across.push_back(f);
      across.push_back(half);
      if (across.size() == 2) offer(ends(c, m));
    }
    offer(ends(a, m));
    offer(ends(b, m));
  }

  std::vector<RowVector3d> places_;
  std::vector<std::array<int, 3>> faces_;
  std::vector<FacePart> parts_;
  std::map<Ends, std::vector<int>> beside_;
  std::priority_queue<Open> open_;
};

}  // namespace

SplitMesh splitLongEdges(const TriangleMesh& mesh, int count) {
  Splitter splitter(mesh);
  splitter.run(static_cast<std::size_t>(std::max(count, 0)));
  return splitter.result();
}

}  // namespace posture
