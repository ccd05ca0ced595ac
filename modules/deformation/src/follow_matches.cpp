// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/error.h>
#include <posture/core/parallel.h>
#include <posture/deformation/follow_matches.h>
#include <posture/mesh/rigid_motion.h>
#include <posture/mesh/vertex_neighbors.h>

#include <Eigen/Geometry>

#include <algorithm>

namespace posture {
namespace {

/// Of these a rigid motion is made that one wrong match does not decide.
constexpr std::size_t ENOUGH = 12;

/// Known vertices around `start`, ring by ring, until there are enough.
class KnownNearby {
 public:
  KnownNearby(const VertexNeighbors& neighbors, const std::vector<char>& known)
      : neighbors_(neighbors), known_(known), seen_(known.size(), -1) {}

  const std::vector<int>& find(int start) {
    ++query_;
    found_.clear();
    ring_.assign(1, start);
    seen_[start] = query_;
    while (!ring_.empty() && found_.size() < ENOUGH) {
      next_.clear();
      for (int v : ring_) {
        if (known_[v]) found_.push_back(v);
        for (const int* w = neighbors_.begin(v); w != neighbors_.end(v); ++w) {
          if (seen_[*w] == query_) continue;
          seen_[*w] = query_;
          next_.push_back(*w);
        }
      }
      ring_.swap(next_);
    }
    return found_;
  }

 private:
  const VertexNeighbors& neighbors_;
  const std::vector<char>& known_;
  std::vector<int> seen_;  // the last query that met each vertex
  std::vector<int> found_, ring_, next_;
  int query_ = -1;
};

}  // namespace

Points followMatches(const TriangleMesh& mesh,
                     const std::vector<char>& known,
                     const Points& places,
                     const Points& extra,
                     const std::vector<int>& anchor) {
  const int n = static_cast<int>(mesh.vertices.rows()), e = static_cast<int>(extra.rows());
  require(static_cast<int>(known.size()) == n && places.rows() == n &&
              static_cast<int>(anchor.size()) == e,
          "followMatches: sizes do not agree");
  const VertexNeighbors neighbors(mesh.faces, n);
  // Few altogether move everything: nobody need look for them over all of the surface.
  std::vector<int> all;
  for (int v = 0; v < n && all.size() < ENOUGH; ++v)
    if (known[v]) all.push_back(v);
  const bool few = all.size() < ENOUGH;
  Points moved(n + e, 3);
  forBlocks(n + e, [&](int first, int last) {
    KnownNearby nearby(neighbors, known);
    for (int i = first; i < last; ++i) {
      if (i < n && known[i]) {
        moved.row(i) = places.row(i);
        continue;
      }
      const std::vector<int>& around = few ? all : nearby.find(i < n ? i : anchor[i - n]);
      const Eigen::Isometry3d motion =
          rigidMotion(mesh.vertices(around, Eigen::all), places(around, Eigen::all));
      const Eigen::Vector3d point =
          i < n ? mesh.vertices.row(i).transpose() : extra.row(i - n).transpose();
      moved.row(i) = (motion * point).transpose();
    }
  });
  return moved;
}

}  // namespace posture
