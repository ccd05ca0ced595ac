// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/mesh/half_edge_mesh.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/shapes.h"
#include "surface/repair.h"

namespace posture {
namespace {

using testing::ElementsAre;

bool isManifold(const Faces& faces, int vertex_count) {
  try {
    return HalfEdgeMesh(faces, vertex_count).check().empty();
  } catch (const std::invalid_argument&) {
    return false;
  }
}

Faces without(const Faces& faces, int first, int count) {
  Faces rest(faces.rows() - count, 3);
  rest << faces.topRows(first), faces.bottomRows(faces.rows() - first - count);
  return rest;
}

TEST(LargestFans, separateTwoSheetsThatMeetInAVertex) {
  // Three faces around vertex 0 on one side, one on the other.
  Faces faces(4, 3);
  faces << 0, 1, 2, 0, 2, 3, 0, 3, 4, 0, 5, 6;
  EXPECT_FALSE(isManifold(faces, 7));
  EXPECT_EQ(largestFans(faces, 7), Faces(faces.topRows(3)));
}

TEST(LargestFans, leaveAManifoldAsItIs) {
  const TriangleMesh sphere = test::sphere(2);
  EXPECT_EQ(largestFans(sphere.faces, static_cast<int>(sphere.vertices.rows())), sphere.faces);
}

TEST(BoundaryLoops, runAgainstTheFaces) {
  Faces faces(1, 3);
  faces << 0, 1, 2;
  EXPECT_THAT(boundaryLoops(faces, 3), ElementsAre(ElementsAre(0, 2, 1)));
  const TriangleMesh sphere = test::sphere(1);
  EXPECT_TRUE(boundaryLoops(sphere.faces, static_cast<int>(sphere.vertices.rows())).empty());
}

TEST(PinHoles, areClosedAndLargeHolesAreNot) {
  TriangleMesh grid = test::grid(20, 20, 20, 20);
  // Two squares, of 1 and of 3 x 3 cells.
  const auto cell = [](int column, int row) { return 2 * (20 * row + column); };
  grid.faces = without(grid.faces, cell(15, 15), 2);
  for (int row = 7; row >= 5; --row) grid.faces = without(grid.faces, cell(5, row), 6);
  const int n = static_cast<int>(grid.vertices.rows());
  ASSERT_EQ(boundaryLoops(grid.faces, n).size(), 3u);
  const Faces closed = closePinHoles(grid, 5);
  EXPECT_EQ(closed.rows(), grid.faces.rows() + 2);
  EXPECT_EQ(boundaryLoops(closed, n).size(), 2u);
  EXPECT_TRUE(isManifold(closed, n));
  EXPECT_EQ(closePinHoles(grid, 13).rows(), grid.faces.rows() + 2 + 10);
}

TEST(SmallPieces, goAndAreCounted) {
  const TriangleMesh sphere = test::sphere(1);
  const int n = static_cast<int>(sphere.vertices.rows());
  TriangleMesh two = sphere;
  two.vertices.conservativeResize(n + 3, 3);
  two.vertices.bottomRows(3).setZero();
  two.faces.conservativeResize(sphere.faces.rows() + 1, 3);
  two.faces.bottomRows(1) << n, n + 1, n + 2;
  int dropped = 0;
  EXPECT_EQ(withoutSmallPieces(two.faces, n + 3, 10, dropped), sphere.faces);
  EXPECT_EQ(dropped, 1);
  std::vector<int> kept;
  EXPECT_EQ(withoutLooseVertices({two.vertices, sphere.faces}, kept).vertices, sphere.vertices);
}

}  // namespace
}  // namespace posture
