// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/mesh/connected_parts.h>

#include <gtest/gtest.h>

#include "support/shapes.h"
#include <algorithm>
#include <vector>

namespace posture {
namespace {

TEST(ConnectedParts, areNumberedByTheirFirstFaceAndHaveTheirArea) {
  const TriangleMesh small = test::grid(2, 2, 1, 1), large = test::grid(3, 1, 3, 1);
  const TriangleMesh mesh = test::joined(small, large);
  const ConnectedParts parts = connectedParts(mesh);
  ASSERT_EQ(parts.area.size(), 2u);
  EXPECT_DOUBLE_EQ(parts.area[0], 1);
  EXPECT_DOUBLE_EQ(parts.area[1], 3);
  EXPECT_EQ(parts.largest, 1);
  ASSERT_EQ(parts.of_face.size(), static_cast<std::size_t>(mesh.faces.rows()));
  for (int f = 0; f < mesh.faces.rows(); ++f)
    EXPECT_EQ(parts.of_face[f], f < small.faces.rows() ? 0 : 1);
}

TEST(ConnectedParts, oneCommonVertexJoins) {
  TriangleMesh mesh;
  mesh.vertices = Points::Random(5, 3);
  mesh.faces.resize(2, 3);
  mesh.faces << 0, 1, 2, 2, 3, 4;
  EXPECT_EQ(connectedParts(mesh).area.size(), 1u);
}

TEST(ConnectedParts, ofMarkedVertices) {
  const TriangleMesh strip = test::grid(10, 2, 10, 2);
  const int n = static_cast<int>(strip.vertices.rows());
  const VertexNeighbors neighbors(strip.faces, n);
  std::vector<char> marked(n, 0);
  EXPECT_TRUE(markedParts(neighbors, marked).empty());
  // Both ends, and a vertex in the middle.
  std::vector<int> left, right, middle;
  for (int v = 0; v < n; ++v) {
    const double x = strip.vertices(v, 0), y = strip.vertices(v, 1);
    std::vector<int>* part = x < 2.5            ? &left
                             : x > 7.5          ? &right
                             : x == 5 && y == 1 ? &middle
                                                : nullptr;
    if (part == nullptr) continue;
    part->push_back(v);
    marked[v] = 1;
  }
  ASSERT_EQ(middle.size(), 1U);
  std::vector<std::vector<int>> parts = markedParts(neighbors, marked);
  ASSERT_EQ(parts.size(), 3U);
  for (std::vector<int>& part : parts) {
    EXPECT_EQ(part.front(), *std::min_element(part.begin(), part.end()));
    std::sort(part.begin(), part.end());
  }
  for (const auto& expected : {left, right, middle})
    EXPECT_EQ(std::count(parts.begin(), parts.end(), expected), 1);
}

TEST(ConnectedParts, ofNothingAreNone) {
  EXPECT_EQ(connectedParts({Points(3, 3), Faces(0, 3)}).largest, -1);
}

}  // namespace
}  // namespace posture
