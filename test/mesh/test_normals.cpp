// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/mesh/edges.h>
#include <posture/mesh/normals.h>

#include <gtest/gtest.h>

#include "support/shapes.h"

namespace posture {
namespace {

TEST(VertexNormals, pointUpFromAPlane) {
  const Points normals = vertexNormals(test::grid(6, 4, 3, 1));
  EXPECT_EQ(normals.rowwise() - Eigen::RowVector3d(0, 0, 1), Points::Zero(35, 3));
}

TEST(VertexNormals, pointOutOfASphere) {
  for (int levels : {2, 3, 4}) {
    const TriangleMesh sphere = test::sphere(levels);
    const Points normals = vertexNormals(sphere);
    EXPECT_LT((normals.rowwise().norm().array() - 1).abs().maxCoeff(), 1e-12);
    // Faces lean by their circumradius, over half an edge; round a vertex most of that cancels.
    const double lean = 0.125 * meanEdgeLength(sphere);
    EXPECT_LT((normals - sphere.vertices).rowwise().norm().maxCoeff(), lean);
  }
}

TEST(VertexNormals, turnRoundWithTheFaces) {
  TriangleMesh sphere = test::sphere(1);
  const Points outwards = vertexNormals(sphere);
  sphere.faces.col(0).swap(sphere.faces.col(1));
  EXPECT_LT((vertexNormals(sphere) + outwards).norm(), 1e-12);
}

TEST(VertexNormals, weighFacesByTheirArea) {
  // Two faces at right angles on the edge 0 1, one of three times the other's area.
  TriangleMesh roof;
  roof.vertices.resize(4, 3);
  roof.vertices << 0, 0, 0, 0, 1, 0, -3, 0, 0, 0, 0, -1;
  roof.faces.resize(2, 3);
  roof.faces << 0, 1, 2, 1, 0, 3;
  const Points normals = vertexNormals(roof);
  const Eigen::RowVector3d ridge = Eigen::RowVector3d(1, 0, 3).normalized();
  EXPECT_LT((normals.row(0) - ridge).norm(), 1e-12);
  EXPECT_LT((normals.row(1) - ridge).norm(), 1e-12);
  EXPECT_LT((normals.row(2) - Eigen::RowVector3d(0, 0, 1)).norm(), 1e-12);
  EXPECT_LT((normals.row(3) - Eigen::RowVector3d(1, 0, 0)).norm(), 1e-12);
}

TEST(VertexNormals, areZeroWhereNoFaceHasAnArea) {
  TriangleMesh mesh = test::grid(2, 2, 1, 1);
  mesh.vertices.conservativeResize(12, 3);
  mesh.vertices.bottomRows(3) << 5, 5, 5, 6, 5, 5, 7, 5, 5;
  mesh.faces.conservativeResize(mesh.faces.rows() + 2, 3);
  mesh.faces.bottomRows(2) << 9, 10, 9, 10, 4, 4;  // 11 is in none
  const Points normals = vertexNormals(mesh);
  EXPECT_EQ(normals.bottomRows(3), Points::Zero(3, 3));
  EXPECT_LT((normals.row(4) - Eigen::RowVector3d(0, 0, 1)).norm(), 1e-12);
}

TEST(VertexNormals, ofAMeshWithoutFacesAreZero) {
  TriangleMesh points;
  points.vertices = test::randomPoints(4, 1);
  EXPECT_EQ(vertexNormals(points), Points::Zero(4, 3));
}

}  // namespace
}  // namespace posture
