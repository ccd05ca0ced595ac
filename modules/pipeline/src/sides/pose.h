// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/mesh/clean_mesh.h>

namespace posture {

/// A frame and a unit of length of a shape's own: the origin at the centroid of its surface, the
/// axes those of its second moments, pointing to where the surface reaches farther.
struct Pose {
  Eigen::RowVector3d center = Eigen::RowVector3d::Zero();
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  ///< columns; a rotation
  double unit = 1;                                     ///< what lengths are multiplied by

  Points into(const Points& points) const;   ///< from the given frame
  Points outOf(const Points& points) const;  ///< back to it
};

/// In square roots of the area: the k-th eigenvalue is then near 4 pi k.
Pose poseOf(const TriangleMesh& mesh);

/// The mesh in its pose, coordinates rounded far below an edge: the same body, however it was
/// turned and moved, has the same numbers.
TriangleMesh posed(const TriangleMesh& mesh, const Pose& pose);

/// The same surface with vertices and faces in an order that follows from the pose alone, so that
/// the order they came in does not matter.
CleanMesh inOrder(const CleanMesh& clean, const Pose& pose);

}  // namespace posture
