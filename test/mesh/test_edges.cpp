// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/mesh/areas.h>
#include <posture/mesh/corners.h>
#include <posture/mesh/deformation_scale.h>
#include <posture/mesh/edges.h>

#include <gtest/gtest.h>

#include "support/shapes.h"

namespace posture {
namespace {

/// Two triangles over one square, and a third one on their common edge 1-2.
Faces threeOnAnEdge() {
  Faces faces(3, 3);
  faces << 0, 1, 2, 2, 1, 3, 1, 2, 4;
  return faces;
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

TEST(Areas, ofASurfaceAreThoseOfItsFacesTogether) {
  const TriangleMesh grid = test::grid(4, 3, 2, 8);
  EXPECT_DOUBLE_EQ(surfaceArea(grid), 16);
  EXPECT_DOUBLE_EQ(rootArea(grid), 4);
  EXPECT_EQ(surfaceArea({grid.vertices, Faces(0, 3)}), 0);
}

TEST(Edges, medianRatioIsThatOfMostEdges) {
  const TriangleMesh mesh = test::sphere(2);
  Points places = 2.5 * mesh.vertices;
  places.row(7) << 9, 9, 9;
  EXPECT_NEAR(medianEdgeRatio(mesh, places), 2.5, 1e-12);
  EXPECT_EQ(medianEdgeRatio({mesh.vertices, Faces(0, 3)}, places), 1);
}

TEST(Edges, scaleIsNotThatOfNoise) {
  const TriangleMesh mesh = test::sphere(4);
  const Points noise =
      0.2 * meanEdgeLength(mesh) * test::randomPoints(static_cast<int>(mesh.vertices.rows()), 3);
  const Points noisy = 2.5 * (mesh.vertices + noise);
  EXPECT_GT(medianEdgeRatio(mesh, noisy), 2.5 * 1.005);
  EXPECT_NEAR(scaleWithoutNoise(mesh, noisy), 2.5, 2.5 * 0.002);
}

}  // namespace
}  // namespace posture
