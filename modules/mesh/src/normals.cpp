// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/mesh/normals.h>

#include <Eigen/Geometry>

namespace posture {

Points vertexNormals(const TriangleMesh& mesh) {
  Points normals = Points::Zero(mesh.vertices.rows(), 3);
  for (int f = 0; f < mesh.faces.rows(); ++f) {
    const Eigen::Vector3d a = mesh.vertices.row(mesh.faces(f, 0));
    const Eigen::Vector3d b = mesh.vertices.row(mesh.faces(f, 1));
    const Eigen::Vector3d c = mesh.vertices.row(mesh.faces(f, 2));
    const Eigen::RowVector3d twice_area = (b - a).cross(c - a).transpose();
    for (int k = 0; k < 3; ++k) normals.row(mesh.faces(f, k)) += twice_area;
  }
  for (int v = 0; v < normals.rows(); ++v) normals.row(v).normalize();  // leaves zero as it is
  return normals;
}

}  // namespace posture
