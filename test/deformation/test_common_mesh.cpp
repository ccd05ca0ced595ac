// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/deformation/common_mesh.h>
#include <posture/mesh/edges.h>

#include <gtest/gtest.h>

#include "support/shapes.h"
#include <cmath>

namespace posture {
namespace {

std::vector<VertexPair> everySecond(const TriangleMesh& mesh) {
  std::vector<VertexPair> pairs;
  for (int v = 0; v < mesh.vertices.rows(); v += 2) pairs.push_back({v, v});
  return pairs;
}

TEST(DeformationEnergy, vanishesForARigidMotion) {
  const TriangleMesh sphere = test::sphere(3);
  TriangleMesh moved = sphere;
  moved.vertices.col(0).swap(moved.vertices.col(1));
  moved.vertices.rowwise() += Eigen::RowVector3d(1, 2, 3);
  const CommonMeshes meshes = computeCommonMeshes(sphere, moved, everySecond(sphere));
  EXPECT_NEAR(deformationEnergy(meshes.from_source), 0, 1e-18);
  EXPECT_NEAR(deformationEnergy(meshes.from_target), 0, 1e-18);
}

TEST(DeformationEnergy, isTheSumOfSquaredLengthChanges) {
  CommonMesh mesh;
  mesh.faces.resize(1, 3);
  mesh.faces << 0, 1, 2;
  mesh.source.resize(3, 3);
  mesh.source << 0, 0, 0, 3, 0, 0, 0, 4, 0;
  mesh.target = 2 * mesh.source;
  EXPECT_DOUBLE_EQ(deformationEnergy(mesh), 3 * 3 + 4 * 4 + 5 * 5);
}

TEST(DeformationEnergy, ofScalingIsKnownForEveryCommonMesh) {
  const TriangleMesh sphere = test::sphere(3);
  TriangleMesh grown = sphere;
  grown.vertices *= 1.1;
  const CommonMeshes meshes = computeCommonMeshes(sphere, grown, everySecond(sphere));
  for (const CommonMesh& mesh : {meshes.from_source, meshes.from_target}) {
    double squares = 0;
    for (const Edge& e : meshEdges(mesh.faces))
      squares += (mesh.source.row(e.first) - mesh.source.row(e.second)).squaredNorm();
    EXPECT_GT(squares, 0);
    EXPECT_NEAR(deformationEnergy(mesh), 0.01 * squares, 1e-9);
  }
}

TEST(DeformationEnergy, isInfiniteWithoutEdges) {
  const TriangleMesh sphere = test::sphere(1);
  const CommonMeshes none = computeCommonMeshes(sphere, sphere, {});
  EXPECT_TRUE(std::isinf(deformationEnergy(none.from_source)));
}

}  // namespace
}  // namespace posture
