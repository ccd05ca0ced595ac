// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/types.h>

#include <limits>
#include <vector>

namespace posture {

/// Where a ray first meets a mesh.
struct RayHit {
  int face = -1;  ///< -1: nowhere; the other members then mean nothing
  double distance = std::numeric_limits<double>::infinity();  ///< in lengths of the direction
  Eigen::Vector3d barycentric = Eigen::Vector3d::Zero();
};

/// Rays against a mesh, both sides of its faces, by a tree of boxes; the intersection is that of
/// Moeller and Trumbore, Fast, Minimum Storage Ray-Triangle Intersection, 1997. May be used from
/// several threads.
class RayCaster {
 public:
  /// \throws std::invalid_argument  a face names a vertex that is not there.
  explicit RayCaster(const TriangleMesh& mesh);

  /// Of faces met at the same distance, the one with the lowest number.
  RayHit cast(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction) const;

 private:
  struct Node {
    Eigen::Vector3d low, high;
    int begin = 0, end = 0;  // faces in order_; of an inner node none
    int second = 0;          // the second child; the first follows its parent
  };

  void build(int begin, int end, const Points& centers);
  void meet(int face,
            const Eigen::Vector3d& origin,
            const Eigen::Vector3d& direction,
            RayHit& best) const;

  TriangleMesh mesh_;
  std::vector<int> order_;
  std::vector<Node> nodes_;
};

}  // namespace posture
