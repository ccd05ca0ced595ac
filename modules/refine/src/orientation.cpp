// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/error.h>
#include <posture/refine/orientation.h>

#include <Eigen/Geometry>

namespace posture {
namespace {

/// Normal of the face with twice its area as length.
Eigen::Vector3d areaNormal(const Points& vertices, const Faces& faces, int face) {
  const Eigen::Vector3d a = vertices.row(faces(face, 0));
  const Eigen::Vector3d b = vertices.row(faces(face, 1));
  const Eigen::Vector3d c = vertices.row(faces(face, 2));
  return (b - a).cross(c - a);
}

}  // namespace

Points vertexNormals(const TriangleMesh& mesh) {
  Points normals = Points::Zero(mesh.vertices.rows(), 3);
  for (int f = 0; f < mesh.faces.rows(); ++f) {
    const Eigen::RowVector3d normal = areaNormal(mesh.vertices, mesh.faces, f).transpose();
    for (int k = 0; k < 3; ++k) normals.row(mesh.faces(f, k)) += normal;
  }
  normals.rowwise().normalize();
  return normals;
}

double orientationVote(const CommonMesh& mesh, const Points& target_normals) {
  require(target_normals.rows() == mesh.target.rows(), "orientationVote: one normal a vertex");
  double vote = 0, area = 0;
  for (int f = 0; f < mesh.faces.rows(); ++f) {
    const Eigen::Vector3d normal = areaNormal(mesh.target, mesh.faces, f);
    const Eigen::Vector3d expected =
        (target_normals.row(mesh.faces(f, 0)) + target_normals.row(mesh.faces(f, 1)) +
         target_normals.row(mesh.faces(f, 2)))
            .transpose();
    const double agreement = normal.dot(expected);
    vote += agreement > 0 ? normal.norm() : (agreement < 0 ? -normal.norm() : 0);
    area += normal.norm();
  }
  return area > 0 ? vote / area : 0;
}

}  // namespace posture
