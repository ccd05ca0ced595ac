// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/correspondence.h>
#include <posture/core/types.h>

namespace posture {

/// Where a place on a mesh is: in its face, or at its vertex where it names no face.
/// \pre  its vertex is not -1.
inline Eigen::RowVector3d positionOf(const TriangleMesh& mesh, const SurfacePoint& place) {
  if (place.face < 0) return mesh.vertices.row(place.vertex);
  Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
  for (int k = 0; k < 3; ++k)
    sum += place.barycentric[k] * mesh.vertices.row(mesh.faces(place.face, k));
  return sum;
}

}  // namespace posture
