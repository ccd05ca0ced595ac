// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/mesh/half_edge_mesh.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <utility>

namespace posture::test {

/// Vertices - edges + faces, with `vertices` of them.
inline int eulerNumber(int vertices, const Faces& faces) {
  std::set<std::pair<int, int>> edges;
  for (const auto& f : faces.rowwise())
    for (int k = 0; k < 3; ++k) edges.insert(std::minmax(f[k], f[(k + 1) % 3]));
  return vertices - static_cast<int>(edges.size()) + static_cast<int>(faces.rows());
}

/// Of all vertices, in faces or not.
inline int eulerNumber(const TriangleMesh& mesh) {
  return eulerNumber(static_cast<int>(mesh.vertices.rows()), mesh.faces);
}

/// The constructor of HalfEdgeMesh refuses what is not manifold or not oriented.
inline void expectManifold(const TriangleMesh& mesh) {
  EXPECT_NO_THROW(HalfEdgeMesh(mesh.faces, static_cast<int>(mesh.vertices.rows())));
}

}  // namespace posture::test
