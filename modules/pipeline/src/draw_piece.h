// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/types.h>
#include <posture/mesh/point_index.h>

#include <Eigen/Geometry>

#include <optional>
#include <vector>

namespace posture {

/// In mean edges of a target: what lies this near to its surface lies on it.
constexpr double ON_SURFACE = 2;

/// A piece of a body, at the scale of the target; at least one point.
struct Piece {
  Points points;   ///< n x 3
  Points normals;  ///< n x 3
  int first = 0;   ///< the point where it begins: nearest to the rest of the body
};

/// Vertices of a target that a piece may come to lie on.
class TargetPart {
 public:
  /// \param vertices, normals  of the whole target, n x 3; kept by reference.
  /// \param part  the vertices that count.
  /// \param edge, size  the target's mean edge length and the square root of its area.
  TargetPart(const Points& vertices,
             const Points& normals,
             std::vector<int> part,
             double edge,
             double size);

  bool empty() const { return vertex_.empty(); }
  double edge() const { return edge_; }
  double size() const { return size_; }

  struct Near {
    int vertex = -1;       ///< of the target
    double distance = 0;   ///< in mean edges
    bool same_way = true;  ///< both surfaces look the same way
  };

  /// \pre not empty.
  Near nearest(const Eigen::RowVector3d& place) const;

  /// For each point of a piece. \pre not empty.
  std::vector<Near> nearest(const Piece& piece, const Eigen::Isometry3d& motion) const;

  /// Places of vertices of the target.
  Points places(const std::vector<int>& vertices) const;

 private:
  const Points &vertices_, &normals_;
  std::vector<int> vertex_;
  std::optional<PointIndex> index_;
  double edge_, size_;
};

/// The rows of a matrix, moved.
Points moved(const Eigen::Isometry3d& motion, const Points& points);


/// Whether most of a piece lies on a target so, and looks the same way.
bool liesOn(const TargetPart& target, const Piece& piece, const Eigen::Isometry3d& motion);

/// Where a piece fits a target: drawn there, as iterated closest points (Besl and McKay 1992), from
/// a motion and from those that turn it every way about the place where the piece begins, as a
/// joint may have bent there. Nothing where it fits nowhere, or elsewhere nearly as well, or is of
/// too few points to tell.
std::optional<Eigen::Isometry3d> drawPiece(const TargetPart& target,
                                           const Piece& piece,
                                           const Eigen::Isometry3d& motion);

}  // namespace posture
