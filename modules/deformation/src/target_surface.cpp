// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "target_surface.h"

#include <posture/mesh/edges.h>
#include <posture/mesh/nearest_on_faces.h>
#include <posture/mesh/normals.h>

#include <algorithm>
#include <limits>

namespace posture {

using Eigen::Vector3d;

TargetSurface::TargetSurface(const TriangleMesh& mesh)
    : mesh_(mesh),
      edge_(meanEdgeLength(mesh)),
      normals_(vertexNormals(mesh)),
      neighbors_(mesh.faces, static_cast<int>(mesh.vertices.rows())),
      on_boundary_(boundaryVertices(mesh.faces, static_cast<int>(mesh.vertices.rows()))),
      faces_at_(mesh.faces, static_cast<int>(mesh.vertices.rows())),
      across_(facesAcross(mesh.faces)),
      index_(mesh.vertices) {}

/// On a side without a neighbour, or at a corner where the surface ends.
bool TargetSurface::onRim(const SurfacePoint& at) const {
  constexpr double ON_SIDE = 1e-9;
  int corners = 0, corner = -1;
  for (int k = 0; k < 3; ++k)
    if (at.barycentric[k] > ON_SIDE) {
      ++corners;
      corner = k;
    }
  if (corners == 1) return onBoundary(mesh_.faces(at.face, corner));
  for (int k = 0; k < 3; ++k)
    if (corners == 2 && at.barycentric[(k + 2) % 3] <= ON_SIDE && across_(at.face, k) < 0)
      return onBoundary(mesh_.faces(at.face, k)) && onBoundary(mesh_.faces(at.face, (k + 1) % 3));
  return false;
}

SurfacePlace TargetSurface::find(const Vector3d& point,
                                 const Vector3d& normal,
                                 const std::vector<int>& starts) const {
  // A normal that is off by a radian counts as two edges.
  const double normal_weight = 4 * edge_ * edge_;
  const auto distance = [&](int t) {
    return (mesh_.vertices.row(t).transpose() - point).squaredNorm() +
           normal_weight * (normals_.row(t).transpose() - normal).squaredNorm();
  };
  int best = starts.front();
  double least = std::numeric_limits<double>::infinity();
  const auto take = [&](int t) {
    const double d = distance(t);
    if (!(d < least || (d == least && t < best))) return false;
    least = d;
    best = t;
    return true;
  };
  for (int t : starts) take(t);
  for (bool moved = true; moved;) {
    moved = false;
    const int here = best;
    for (const int* w = neighbors_.begin(here); w != neighbors_.end(here); ++w) {
      moved |= take(*w);
      for (const int* u = neighbors_.begin(*w); u != neighbors_.end(*w); ++u) moved |= take(*u);
    }
  }
  SurfacePlace found;
  found.at.vertex = best;
  found.place = mesh_.vertices.row(best);
  found.normal = normals_.row(best);
  NearestPlace nearest;
  const auto look_around = [&](int vertex) {
    lookAround(mesh_.vertices, mesh_.faces, faces_at_, vertex, point, nearest);
  };
  look_around(best);
  std::for_each(neighbors_.begin(best), neighbors_.end(best), look_around);
  if (nearest.face < 0) return found;
  const auto corners = mesh_.faces.row(nearest.face);
  found.at = {corners[largestCorner(nearest.barycentric)], nearest.face, nearest.barycentric};
  found.place = nearest.place;
  Vector3d sum = Vector3d::Zero();
  for (int k = 0; k < 3; ++k) sum += nearest.barycentric[k] * normals_.row(corners[k]).transpose();
  found.normal = sum.normalized();
  const Vector3d off = point - found.place;
  const double beside = (off - found.normal.dot(off) * found.normal).norm();
  found.beyond_rim = beside > 0.5 * edge_ && onRim(found.at);
  return found;
}

}  // namespace posture
