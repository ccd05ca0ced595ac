// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/mesh/areas.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace posture {

Vector faceAreas(const TriangleMesh& mesh) {
  Vector areas(mesh.faces.rows());
  for (int f = 0; f < mesh.faces.rows(); ++f) {
    const Eigen::Vector3d a = mesh.vertices.row(mesh.faces(f, 0));
    const Eigen::Vector3d b = mesh.vertices.row(mesh.faces(f, 1));
    const Eigen::Vector3d c = mesh.vertices.row(mesh.faces(f, 2));
    areas[f] = (b - a).cross(c - a).norm() / 2;
  }
  return areas;
}

double surfaceArea(const TriangleMesh& mesh) { return faceAreas(mesh).sum(); }

double rootArea(const TriangleMesh& mesh) { return std::sqrt(surfaceArea(mesh)); }

double coarseness(const TriangleMesh& mesh) {
  const Vector areas = faceAreas(mesh);
  double sum = 0;
  for (int f = 0; f < mesh.faces.rows(); ++f) {
    double longest = 0;
    for (int k = 0; k < 3; ++k)
      longest = std::max(
          longest,
          (mesh.vertices.row(mesh.faces(f, k)) - mesh.vertices.row(mesh.faces(f, (k + 1) % 3)))
              .squaredNorm());
    sum += areas[f] * longest;
  }
  const double area = areas.sum();
  return area > 0 ? std::sqrt(sum) / area : 0;
}

}  // namespace posture
