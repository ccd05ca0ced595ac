// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/mesh/edges.h>
#include <posture/mesh/vertex_neighbors.h>

#include <gtest/gtest.h>

#include "support/shapes.h"
#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace posture {
namespace {

int vertexCount(const TriangleMesh& mesh) { return static_cast<int>(mesh.vertices.rows()); }

void expectNeighborsOfFaces(const Faces& faces, int vertex_count) {
  std::vector<std::set<int>> expected(vertex_count);
  for (int f = 0; f < faces.rows(); ++f)
    for (int k = 0; k < 3; ++k)
      for (int l = 0; l < 3; ++l)
        if (k != l) expected[faces(f, k)].insert(faces(f, l));
  const VertexNeighbors neighbors(faces, vertex_count);
  for (int v = 0; v < vertex_count; ++v)
    EXPECT_EQ(std::vector<int>(neighbors.begin(v), neighbors.end(v)),
              std::vector<int>(expected[v].begin(), expected[v].end()))
        << v;
}

void expectNeighborsOfNeighbors(const Faces& faces, int vertex_count) {
  const VertexNeighbors one(faces, vertex_count), two = one.withinTwoEdges();
  for (int v = 0; v < vertex_count; ++v) {
    std::set<int> expected(one.begin(v), one.end(v));
    for (const int* w = one.begin(v); w != one.end(v); ++w)
      expected.insert(one.begin(*w), one.end(*w));
    expected.erase(v);
    EXPECT_EQ(std::vector<int>(two.begin(v), two.end(v)),
              std::vector<int>(expected.begin(), expected.end()))
        << v;
  }
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

/// A fin of three faces on one edge, a bow-tie at vertex 3, faces against each other, vertex 8 in
/// none.
Faces strangeFaces() {
  Faces faces(5, 3);
  faces << 0, 1, 2, 0, 1, 3, 1, 0, 4, 3, 5, 6, 5, 6, 7;
  return faces;
}

TEST(VertexNeighbors, areTheCornersOfItsFaces) {
  const TriangleMesh sphere = test::sphere(2), grid = test::grid(7, 4, 1, 1);
  expectNeighborsOfFaces(sphere.faces, vertexCount(sphere));
  expectNeighborsOfFaces(grid.faces, vertexCount(grid));
  expectNeighborsOfFaces(strangeFaces(), 9);
  expectNeighborsOfFaces(Faces(0, 3), 2);
}

TEST(VertexNeighbors, withinTwoEdgesAreTheirsAndTheirNeighborsButNotItself) {
  const TriangleMesh sphere = test::sphere(2), grid = test::grid(7, 4, 1, 1);
  expectNeighborsOfNeighbors(sphere.faces, vertexCount(sphere));
  expectNeighborsOfNeighbors(grid.faces, vertexCount(grid));
  expectNeighborsOfNeighbors(strangeFaces(), 9);
  expectNeighborsOfNeighbors(Faces(0, 3), 2);
}

TEST(VertexNeighbors, withinTwoEdgesAreNotAllOthersAtTheRimOfALargeFan) {
  const int rim = 150;
  Faces fan(rim, 3);
  for (int k = 0; k < rim; ++k) fan.row(k) << 0, 1 + k, 1 + (k + 1) % rim;
  const VertexNeighbors two = VertexNeighbors(fan, rim + 1).withinTwoEdges();
  EXPECT_EQ(two.end(0) - two.begin(0), rim);
  EXPECT_EQ(std::vector<int>(two.begin(75), two.end(75)), (std::vector<int>{0, 73, 74, 76, 77}));
}

TEST(VertexNeighbors, doNotDependOnTheOrderOfTheFaces) {
  const TriangleMesh sphere = test::sphere(2);
  expectNeighborsOfFaces(sphere.faces.colwise().reverse(), vertexCount(sphere));
  expectNeighborsOfFaces(sphere.faces.rowwise().reverse(), vertexCount(sphere));
}

TEST(BoundaryVertices, areTheRimOfAGrid) {
  const int columns = 7, rows = 4;
  const TriangleMesh grid = test::grid(columns, rows, 7, 4);
  const std::vector<char> on_boundary = boundaryVertices(grid.faces, vertexCount(grid));
  for (int v = 0; v < vertexCount(grid); ++v) {
    const double x = grid.vertices(v, 0), y = grid.vertices(v, 1);
    EXPECT_EQ(on_boundary[v] != 0, x == 0 || x == columns || y == 0 || y == rows) << v;
  }
}

TEST(BoundaryVertices, areNoneOnAClosedSurfaceAndThoseOfAHoleOnOneWithAHole) {
  TriangleMesh sphere = test::sphere(2);
  const std::vector<char> none(vertexCount(sphere), 0);
  EXPECT_EQ(boundaryVertices(sphere.faces, vertexCount(sphere)), none);
  const Eigen::RowVector3i removed = sphere.faces.row(sphere.faces.rows() - 1);
  sphere.faces.conservativeResize(sphere.faces.rows() - 1, 3);
  std::vector<char> rim = none;
  for (int k = 0; k < 3; ++k) rim[removed[k]] = 1;
  EXPECT_EQ(boundaryVertices(sphere.faces, vertexCount(sphere)), rim);
}

TEST(BoundaryVertices, areNoneWhereMoreThanTwoFacesMeet) {
  Faces two(8, 3);  // tetrahedra on one edge, 0 1
  two << 0, 1, 2, 0, 2, 3, 0, 3, 1, 1, 3, 2, 0, 1, 4, 0, 4, 5, 0, 5, 1, 1, 5, 4;
  EXPECT_EQ(boundaryVertices(two, 6), std::vector<char>(6, 0));
}

TEST(BoundaryVertices, areEndsOfEdgesOfOneFaceOnAnyMesh) {
  expectBoundaryOfFaces(strangeFaces(), 9);
  expectBoundaryOfFaces(Faces(0, 3), 2);
}

}  // namespace
}  // namespace posture
