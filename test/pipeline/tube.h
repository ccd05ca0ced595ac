// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "support/shapes.h"
#include <cmath>

namespace posture::test {

inline constexpr int AROUND = 120, ACROSS = 30;
inline constexpr double PI = 3.141592653589793;

/// A torus with the thickness of its tube times `factor` of the angle around, in (-pi, pi].
template <class Factor>
TriangleMesh tube(const Factor& factor, int around = AROUND, int across = ACROSS) {
  TriangleMesh mesh = test::torus(around, across, 1, 0.35);
  for (auto vertex : mesh.vertices.rowwise()) {
    const double angle = std::atan2(vertex.y(), vertex.x());
    const Eigen::RowVector3d middle(std::cos(angle), std::sin(angle), 0);
    vertex = middle + factor(angle) * (vertex - middle);
  }
  return mesh;
}

}  // namespace posture::test
