// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/types.h>

#include "skeleton.h"
#include <array>
#include <utility>
#include <vector>

namespace posture::synthesis {

/// A closed triangle mesh that can be changed: faces know their corners, vertices their faces.
/// Every operation keeps it a closed 2-manifold of the same genus, or declines and returns false.
class EditMesh {
 public:
  explicit EditMesh(const TriangleMesh& mesh);

  int numSlots() const { return static_cast<int>(point_.size()); }  ///< vertices, dead ones too
  bool isAlive(int v) const { return !faces_of_[v].empty(); }
  int valence(int v) const { return static_cast<int>(faces_of_[v].size()); }
  int numVertices() const;
  const Vec3& point(int v) const { return point_[v]; }
  void move(int v, const Vec3& p) { point_[v] = p; }
  double length(int a, int b) const { return (point_[a] - point_[b]).norm(); }

  std::vector<std::pair<int, int>> edges() const;  ///< a < b, by a, then by face
  std::vector<int> neighbours(int v) const;
  /// The corners opposite to the edge in its two faces; {-1, -1} where there is no such edge.
  std::array<int, 2> oppositeCorners(int a, int b) const;
  Vec3 areaNormal(int v) const;  ///< sum of the cross products of the faces around v
  /// Centre of the faces around v, weighted by area.
  Vec3 areaCentroid(int v) const;

  int split(int a, int b, const Vec3& at);  ///< the new vertex
  bool collapse(int keep, int gone, const Vec3& at);
  bool flip(int a, int b);

  TriangleMesh take() const;

 private:
  using Face = std::array<int, 3>;
  Vec3 crossProduct(const Face& f) const;
  bool collapseTurnsOver(int v, int other, const Vec3& at) const;
  void replaceCorner(int face, int old_corner, int new_corner);
  void addFace(const Face& corners);
  void dropFace(int face);
  void forget(int v, int face);
  std::array<int, 2> facesOfEdge(int a, int b) const;

  std::vector<Vec3> point_;
  std::vector<Face> face_;
  std::vector<std::vector<int>> faces_of_;
};

}  // namespace posture::synthesis
