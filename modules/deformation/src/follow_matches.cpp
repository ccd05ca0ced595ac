// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/error.h>
#include <posture/deformation/follow_matches.h>

#include <Eigen/Geometry>
#include <Eigen/SVD>

namespace posture {
namespace {

/// Vertex neighbours in compressed rows.
struct Adjacency {
  std::vector<int> first, neighbor;

  explicit Adjacency(const TriangleMesh& mesh) : first(mesh.vertices.rows() + 1, 0) {
    for (int i = 0; i < mesh.faces.size(); ++i) first[mesh.faces.data()[i] + 1] += 2;
    for (std::size_t v = 1; v < first.size(); ++v) first[v] += first[v - 1];
    neighbor.resize(first.back());
    std::vector<int> next(first.begin(), first.end() - 1);
    for (int f = 0; f < mesh.faces.rows(); ++f)
      for (int k = 0; k < 3; ++k) {
        const int v = mesh.faces(f, k);
        neighbor[next[v]++] = mesh.faces(f, (k + 1) % 3);
        neighbor[next[v]++] = mesh.faces(f, (k + 2) % 3);
      }
  }
};

/// Known vertices around `start`, ring by ring, until there are enough for a rigid motion that one
/// wrong match does not decide.
class KnownNearby {
 public:
  KnownNearby(const Adjacency& adjacency, const std::vector<char>& known)
      : adjacency_(adjacency), known_(known), seen_(known.size(), -1) {}

  const std::vector<int>& find(int start) {
    constexpr std::size_t ENOUGH = 12;
    found_.clear();
    ring_.assign(1, start);
    seen_[start] = start;
    while (!ring_.empty() && found_.size() < ENOUGH) {
      next_.clear();
      for (int v : ring_) {
        if (known_[v]) found_.push_back(v);
        for (int i = adjacency_.first[v]; i < adjacency_.first[v + 1]; ++i) {
          const int w = adjacency_.neighbor[i];
          if (seen_[w] == start) continue;
          seen_[w] = start;
          next_.push_back(w);
        }
      }
      ring_.swap(next_);
    }
    return found_;
  }

 private:
  const Adjacency& adjacency_;
  const std::vector<char>& known_;
  std::vector<int> seen_, found_, ring_, next_;
};

Eigen::Isometry3d rigidMotion(const TriangleMesh& mesh,
                              const Points& places,
                              const std::vector<int>& vertices) {
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
  if (vertices.empty()) return motion;
  Eigen::Matrix3Xd from(3, vertices.size()), to(3, vertices.size());
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    from.col(i) = mesh.vertices.row(vertices[i]).transpose();
    to.col(i) = places.row(vertices[i]).transpose();
  }
  if (vertices.size() < 3)
    motion.translation() = to.rowwise().mean() - from.rowwise().mean();
  else
    motion.matrix() = Eigen::umeyama(from, to, false);
  return motion;
}

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
  const Adjacency adjacency(mesh);
  Points moved(n + e, 3);
#pragma omp parallel
  {
    KnownNearby nearby(adjacency, known);
#pragma omp for schedule(dynamic, 256)
    for (int i = 0; i < n + e; ++i) {
      if (i < n && known[i]) {
        moved.row(i) = places.row(i);
        continue;
      }
      const Eigen::Isometry3d motion =
          rigidMotion(mesh, places, nearby.find(i < n ? i : anchor[i - n]));
      const Eigen::Vector3d point =
          i < n ? mesh.vertices.row(i).transpose() : extra.row(i - n).transpose();
      moved.row(i) = (motion * point).transpose();
    }
  }
  return moved;
}

}  // namespace posture
