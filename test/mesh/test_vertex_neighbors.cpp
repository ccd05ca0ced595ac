// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/mesh/vertex_neighbors.h>

#include <gtest/gtest.h>

#include "mesh/strange_faces.h"
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

TEST(VertexNeighbors, areTheCornersOfItsFaces) {
  const TriangleMesh sphere = test::sphere(2), grid = test::grid(7, 4, 1, 1);
  expectNeighborsOfFaces(sphere.faces, vertexCount(sphere));
  expectNeighborsOfFaces(grid.faces, vertexCount(grid));
  expectNeighborsOfFaces(test::strangeFaces(), 9);
  expectNeighborsOfFaces(Faces(0, 3), 2);
}

TEST(VertexNeighbors, withinTwoEdgesAreTheirsAndTheirNeighborsButNotItself) {
  const TriangleMesh sphere = test::sphere(2), grid = test::grid(7, 4, 1, 1);
  expectNeighborsOfNeighbors(sphere.faces, vertexCount(sphere));
  expectNeighborsOfNeighbors(grid.faces, vertexCount(grid));
  expectNeighborsOfNeighbors(test::strangeFaces(), 9);
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

}  // namespace
}  // namespace posture
