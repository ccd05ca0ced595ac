// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/mesh/require_mesh.h>

#include <stdexcept>
#include <string>

namespace posture {

void requireMesh(const TriangleMesh& mesh) {
  const Eigen::Index n = mesh.vertices.rows();
  for (Eigen::Index v = 0; v < n; ++v)
    if (!mesh.vertices.row(v).allFinite())
      throw std::invalid_argument("mesh: vertex " + std::to_string(v) + " is not finite");
  for (Eigen::Index f = 0; f < mesh.faces.rows(); ++f)
    if (mesh.faces.row(f).minCoeff() < 0 || mesh.faces.row(f).maxCoeff() >= n)
      throw std::invalid_argument("mesh: face " + std::to_string(f) +
                                  " has a corner that is no vertex");
}

}  // namespace posture
