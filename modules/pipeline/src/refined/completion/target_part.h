// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/correspondence.h>
#include <posture/mesh/point_index.h>
#include <posture/mesh/vertex_neighbors.h>

#include <Eigen/Geometry>

#include <optional>
#include <vector>

namespace posture {

/// In mean edges of a target: what lies this near to its surface lies on it.
constexpr double ON_SURFACE = 2;

/// How well what lies so far from a surface, in its mean edges, lies on it: in (0, 1].
double fitAt(double distance);

/// A piece of a body, at the scale of the target; at least one point.
struct Piece {
  Points points;             ///< n x 3
  Points normals;            ///< n x 3
  int first = 0;             ///< the point where it begins: nearest to the rest of the body
  std::vector<char> on_rim;  ///< n; where its surface ends, so that the body goes on there
  double edge = 0;           ///< its mean edge length
};

/// A surface to lay pieces on. Lengths on it are in mean edges unless said otherwise.
struct PieceTarget {
  /// \param vertex_normals  n x 3; 0 where there is none.
  /// \param mean_edge, body_size  its mean edge length and the square root of its area.
  PieceTarget(TriangleMesh surface, Points vertex_normals, double mean_edge, double body_size);

  std::vector<int> first;  ///< vertex -> the first one at its place
  TriangleMesh mesh;       ///< faces as given, between these
  Points normals;
  VertexNeighbors neighbors;
  VertexFaces faces_around;
  std::vector<char> on_faces;  ///< vertex -> whether it is one's corner: cornersOfFaces()
  double edge, size;
};

/// What of a surface a piece may come to lie on.
class TargetPart {
 public:
  /// \param surface  kept by reference.
  /// \param vertices  those that count; of several at one place the first alone, and none that is
  ///        on no face: left over from what was cut away, or of a floor.
  TargetPart(const PieceTarget& surface, std::vector<int> vertices);

  bool empty() const { return vertex_.empty(); }
  double edge() const { return surface_.edge; }
  double size() const { return surface_.size; }

  struct Near {
    SurfacePoint at;           ///< in the faces around the nearest of the vertices that count
    Eigen::RowVector3d place;  ///< there
    double distance = 0;       ///< from it
    bool same_way = true;      ///< both surfaces look the same way
  };

  /// \pre not empty.
  Near nearest(const Eigen::RowVector3d& place) const;

  /// For each point of a piece. \pre not empty.
  std::vector<Near> nearest(const Piece& piece, const Eigen::Isometry3d& motion) const;

  /// Of the surface that goes on around a piece laid on it, the share that does so where the piece
  /// does not end. \pre not empty.
  double goingOn(const Piece& piece, const Eigen::Isometry3d& motion) const;

  /// Vertices far from each other (farthest-point samples), the first the nearest to a place; of
  /// those that have a normal and lie within a distance of it, in the unit of the mesh.
  std::vector<int> spread(const Eigen::RowVector3d& around, double distance, int count) const;

  const PieceTarget& surface() const { return surface_; }

 private:
  const PieceTarget& surface_;
  std::vector<int> vertex_;
  std::vector<char> counts_;  // each vertex of the surface
  std::optional<PointIndex> index_;
};

/// Rows far from each other (farthest-point samples), from the given one on.
std::vector<int> farthestPoints(const Points& points, int first, int count);

}  // namespace posture
