// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/mesh/clean_mesh.h>

#include <gtest/gtest.h>

#include "sides/pose.h"
#include "support/shapes.h"
#include <algorithm>
#include <array>
#include <set>
#include <vector>

namespace posture {
namespace {

/// A body like no turned image of its own.
TriangleMesh lopsided() {
  TriangleMesh mesh = test::sphere(2);
  for (auto p : mesh.vertices.rowwise())
    p << 3 * p.x() + p.x() * p.x(), 2 * p.y() + 0.3 * p.x() * p.y() + 0.2 * p.y() * p.y(),
        p.z() + 0.2 * p.z() * p.z();
  return mesh;
}

constexpr int STRIDE = 101;  // prime to the numbers of vertices and of faces

/// The same with vertices and faces in another order, and other first corners.
TriangleMesh shuffled(const TriangleMesh& mesh) {
  const int n = static_cast<int>(mesh.vertices.rows()), m = static_cast<int>(mesh.faces.rows());
  TriangleMesh other = mesh;
  for (int v = 0; v < n; ++v) other.vertices.row(v * STRIDE % n) = mesh.vertices.row(v);
  for (int f = 0; f < m; ++f)
    for (int k = 0; k < 3; ++k)
      other.faces(f * STRIDE % m, (k + f) % 3) = mesh.faces(f, k) * STRIDE % n;
  return other;
}

CleanMesh ordered(const TriangleMesh& mesh) {
  const CleanMesh clean = cleanMesh(mesh);
  return inOrder(clean, poseOf(clean.mesh));
}

std::set<std::array<int, 3>> facesOf(const Faces& faces, const std::vector<int>& number) {
  std::set<std::array<int, 3>> found;
  for (const auto& face : faces.rowwise()) {
    std::array<int, 3> corners{number[face[0]], number[face[1]], number[face[2]]};
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    found.insert(corners);
  }
  return found;
}

TEST(InOrder, theOrderThatVerticesAndFacesCameInDoesNotMatter) {
  const CleanMesh one = ordered(lopsided()), other = ordered(shuffled(lopsided()));
  EXPECT_EQ(one.mesh.vertices, other.mesh.vertices);
  EXPECT_EQ(one.mesh.faces, other.mesh.faces);
}

TEST(InOrder, eachInputVertexKeepsItsPlaceAndEachFaceItsWinding) {
  TriangleMesh mesh = shuffled(lopsided());
  const int n = static_cast<int>(mesh.vertices.rows());
  mesh.vertices.conservativeResize(n + 1, 3);
  mesh.vertices.row(n) = mesh.vertices.row(7);  // welded
  const CleanMesh clean = ordered(mesh);
  ASSERT_EQ(clean.clean_vertex.size(), static_cast<std::size_t>(n + 1));
  for (int v = 0; v <= n; ++v) {
    EXPECT_EQ(clean.mesh.vertices.row(clean.clean_vertex[v]), mesh.vertices.row(v)) << v;
    EXPECT_EQ(clean.input_vertex[clean.clean_vertex[v]], v < n ? v : 7);
  }
  std::vector<int> own(n + 1);
  for (int v = 0; v <= n; ++v) own[v] = v;
  EXPECT_EQ(facesOf(clean.mesh.faces, clean.input_vertex), facesOf(mesh.faces, own));
}

}  // namespace
}  // namespace posture
