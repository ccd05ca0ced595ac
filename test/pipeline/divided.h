// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/types.h>

#include <cmath>

namespace posture::test {

/// Divided in two or more by a narrow gap across z, at a share of the height.
inline TriangleMesh divided(TriangleMesh mesh, double share) {
  const double low = mesh.vertices.col(2).minCoeff(), high = mesh.vertices.col(2).maxCoeff();
  const double z = low + share * (high - low), half = 0.01 * (high - low);
  int kept = 0;
  for (int f = 0; f < mesh.faces.rows(); ++f) {
    bool inside = false;
    for (int k = 0; k < 3; ++k)
      inside = inside || std::abs(mesh.vertices(mesh.faces(f, k), 2) - z) < half;
    if (!inside) mesh.faces.row(kept++) = mesh.faces.row(f).eval();
  }
  mesh.faces.conservativeResize(kept, 3);
  return mesh;
}

}  // namespace posture::test
