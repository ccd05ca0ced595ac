// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/mesh/edges.h>

#include <gtest/gtest.h>

#include "mesh/strange_faces.h"
#include "support/shapes.h"
#include <algorithm>
#include <map>
#include <utility>
#include <vector>

namespace posture {
namespace {

/// Two triangles over one square, and a third one on their common edge 1-2.
Faces threeOnAnEdge() {
  Faces faces(3, 3);
  faces << 0, 1, 2, 2, 1, 3, 1, 2, 4;
  return faces;
}

void expectBoundaryOfFaces(const Faces& faces, int vertex_count) {
  std::map<std::pair<int, int>, int> sides;
  for (int f = 0; f < faces.rows(); ++f)
    for (int k = 0; k < 3; ++k) ++sides[std::minmax(faces(f, k), faces(f, (k + 1) % 3))];
  std::vector<char> expected(vertex_count, 0);
  for (const auto& [ends, count] : sides)
    if (count == 1) expected[ends.first] = expected[ends.second] = 1;
  EXPECT_EQ(boundaryVertices(faces, vertex_count), expected);
}

TEST(Edges, eulersNumberOfASphere) {
  const TriangleMesh sphere = test::sphere(2);
  const auto edges = meshEdges(sphere.faces);
  EXPECT_EQ(sphere.vertices.rows() - static_cast<int>(edges.size()) + sphere.faces.rows(), 2);
  for (std::size_t i = 0; i < edges.size(); ++i) {
    EXPECT_EQ(edges[i].faces, 2);
    EXPECT_LT(edges[i].first, edges[i].second);
    if (i > 0) {
      EXPECT_LT(std::pair(edges[i - 1].first, edges[i - 1].second),
                std::pair(edges[i].first, edges[i].second));
    }
  }
}

TEST(Edges, countsTheFacesOfAnEdge) {
  const auto edges = meshEdges(threeOnAnEdge());
  ASSERT_EQ(edges.size(), 7u);
  for (const Edge& e : edges) EXPECT_EQ(e.faces, e.first == 1 && e.second == 2 ? 3 : 1);
}

TEST(Edges, acrossASideLiesTheFaceThatSharesIt) {
  const Faces faces = test::grid(4, 3, 4, 3).faces, across = facesAcross(faces);
  int open = 0;
  for (int f = 0; f < faces.rows(); ++f)
    for (int k = 0; k < 3; ++k) {
      const int g = across(f, k);
      open += g < 0;
      if (g < 0) continue;
      EXPECT_NE(g, f);
      for (const int corner : {faces(f, k), faces(f, (k + 1) % 3)})
        EXPECT_TRUE((faces.row(g).array() == corner).any());
      EXPECT_TRUE((across.row(g).array() == f).any());
    }
  EXPECT_EQ(open, 2 * (4 + 3));  // the outline
}

TEST(Edges, nothingLiesAcrossAnEdgeOfThreeFaces) {
  const Faces across = facesAcross(threeOnAnEdge());
  EXPECT_TRUE((across.array() == -1).all());
  EXPECT_EQ(facesAcross(Faces(0, 3)).rows(), 0);
}

TEST(BoundaryVertices, areTheRimOfAGrid) {
  const int columns = 7, rows = 4;
  const TriangleMesh grid = test::grid(columns, rows, 7, 4);
  const std::vector<char> on_boundary =
      boundaryVertices(grid.faces, static_cast<int>(grid.vertices.rows()));
  for (int v = 0; v < static_cast<int>(grid.vertices.rows()); ++v) {
    const double x = grid.vertices(v, 0), y = grid.vertices(v, 1);
    EXPECT_EQ(on_boundary[v] != 0, x == 0 || x == columns || y == 0 || y == rows) << v;
  }
}

TEST(BoundaryVertices, areNoneOnAClosedSurfaceAndThoseOfAHoleOnOneWithAHole) {
  TriangleMesh sphere = test::sphere(2);
  const std::vector<char> none(static_cast<int>(sphere.vertices.rows()), 0);
  EXPECT_EQ(boundaryVertices(sphere.faces, static_cast<int>(sphere.vertices.rows())), none);
  const Eigen::RowVector3i removed = sphere.faces.row(sphere.faces.rows() - 1);
  sphere.faces.conservativeResize(sphere.faces.rows() - 1, 3);
  std::vector<char> rim = none;
  for (int k = 0; k < 3; ++k) rim[removed[k]] = 1;
  EXPECT_EQ(boundaryVertices(sphere.faces, static_cast<int>(sphere.vertices.rows())), rim);
}

TEST(BoundaryVertices, areNoneWhereMoreThanTwoFacesMeet) {
  Faces two(8, 3);  // tetrahedra on one edge, 0 1
  two << 0, 1, 2, 0, 2, 3, 0, 3, 1, 1, 3, 2, 0, 1, 4, 0, 4, 5, 0, 5, 1, 1, 5, 4;
  EXPECT_EQ(boundaryVertices(two, 6), std::vector<char>(6, 0));
}

TEST(BoundaryVertices, areEndsOfEdgesOfOneFaceOnAnyMesh) {
  expectBoundaryOfFaces(test::strangeFaces(), 9);
  expectBoundaryOfFaces(Faces(0, 3), 2);
}

}  // namespace
}  // namespace posture
