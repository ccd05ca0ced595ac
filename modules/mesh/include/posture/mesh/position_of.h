// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/correspondence.h>
#include <posture/core/types.h>

#include <vector>

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

/// The place of a vertex as one in a face. \param face_of  of each vertex, -1: none
/// (faceOfEachVertex()).
inline SurfacePoint placeOfVertex(const Faces& faces, const std::vector<int>& face_of, int vertex) {
  SurfacePoint place;
  place.vertex = vertex;
  place.face = face_of[vertex];
  if (place.face < 0) return place;
  int corner = 0;  // the first: a face may name a vertex twice
  while (faces(place.face, corner) != vertex) ++corner;
  place.barycentric[corner] = 1;
  return place;
}

}  // namespace posture
