// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/correspondence.h>
#include <posture/core/types.h>
#include <posture/mesh/point_index.h>
#include <posture/mesh/vertex_neighbors.h>

#include <vector>

namespace posture {

/// A place on a surface seen from a point near it.
struct SurfacePlace {
  SurfacePoint at;
  Eigen::Vector3d place = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  ///< unit, interpolated
  bool beyond_rim = false;  ///< the point lies beside the surface: over a hole, or past its end
};

/// A surface on which places near points are looked for.
class TargetSurface {
 public:
  explicit TargetSurface(const TriangleMesh& mesh);

  bool onBoundary(int vertex) const { return on_boundary_[vertex] != 0; }

  int nearestVertex(const Eigen::Vector3d& point) const { return index_.nearest(point).index; }

  /// The place near `point` that faces as `normal` does, found downhill along the edges from the
  /// best of the `starts`.
  SurfacePlace find(const Eigen::Vector3d& point,
                    const Eigen::Vector3d& normal,
                    const std::vector<int>& starts) const;

 private:
  bool onRim(const SurfacePoint& at) const;

  const TriangleMesh& mesh_;
  double edge_;
  Points normals_;
  VertexNeighbors neighbors_;
  std::vector<char> on_boundary_;
  VertexFaces faces_at_;
  Faces across_;
  PointIndex index_;
};

}  // namespace posture
