// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/types.h>
#include <posture/mesh/nearest_in_triangle.h>
#include <posture/mesh/vertex_neighbors.h>

#include <limits>

namespace posture {

/// The nearest place to a point that was found so far, perhaps in no face.
struct NearestPlace {
  int face = -1;
  Eigen::Vector3d barycentric = Eigen::Vector3d::Zero();
  Eigen::Vector3d place = Eigen::Vector3d::Zero();
  double squared = std::numeric_limits<double>::infinity();  ///< distance

  NearestPlace() = default;
  /// To look for what is nearer than a place that is known.
  NearestPlace(const Eigen::Vector3d& known, const Eigen::Vector3d& point)
      : place(known), squared((known - point).squaredNorm()) {}
};

/// Takes the place of a face nearest to `point` if it is nearer than `best`: of equals the first.
inline void lookInFace(const Points& vertices,
                       const Faces& faces,
                       int face,
                       const Eigen::Vector3d& point,
                       NearestPlace& best) {
  const Eigen::Vector3d a = vertices.row(faces(face, 0)), b = vertices.row(faces(face, 1)),
                        c = vertices.row(faces(face, 2));
  const Eigen::Vector3d at = nearestInTriangle(point, a, b, c);
  const Eigen::Vector3d place = at[0] * a + at[1] * b + at[2] * c;
  const double squared = (place - point).squaredNorm();
  if (!(squared < best.squared)) return;
  best.face = face;
  best.barycentric = at;
  best.place = place;
  best.squared = squared;
}

/// The same for all faces at a vertex.
inline void lookAround(const Points& vertices,
                       const Faces& faces,
                       const VertexFaces& faces_at,
                       int vertex,
                       const Eigen::Vector3d& point,
                       NearestPlace& best) {
  for (const int* f = faces_at.begin(vertex); f != faces_at.end(vertex); ++f)
    lookInFace(vertices, faces, *f, point, best);
}

/// The corner that counts most of a place in a face; of equals the first.
inline int largestCorner(const Eigen::Vector3d& barycentric) {
  int corner = 0;
  barycentric.maxCoeff(&corner);
  return corner;
}

}  // namespace posture
