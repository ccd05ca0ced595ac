// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/refine/orientation.h>

#include <gtest/gtest.h>

#include "support/shapes.h"

namespace posture {
namespace {

std::vector<VertexPair> everySecond(const TriangleMesh& mesh) {
  std::vector<VertexPair> pairs;
  for (int v = 0; v < mesh.vertices.rows(); v += 2) pairs.push_back({v, v});
  return pairs;
}

Points normalsAt(const TriangleMesh& mesh, const std::vector<VertexPair>& pairs) {
  const Points normals = vertexNormals(mesh);
  Points at(pairs.size(), 3);
  for (std::size_t i = 0; i < pairs.size(); ++i) at.row(i) = normals.row(pairs[i].target);
  return at;
}

TEST(VertexNormals, pointOutOfASphere) {
  const TriangleMesh sphere = test::sphere(4);
  const Points normals = vertexNormals(sphere);
  for (int v = 0; v < sphere.vertices.rows(); ++v)
    EXPECT_GT(normals.row(v).dot(sphere.vertices.row(v)), 0.999);
}

TEST(OrientationVote, tellsAMotionFromAMirrorImage) {
  const TriangleMesh sphere = test::sphere(3);
  TriangleMesh turned = sphere, mirrored = sphere;
  turned.vertices.col(0) *= -1;
  turned.vertices.col(1) *= -1;
  mirrored.vertices.col(0) *= -1;
  mirrored.faces.col(0).swap(mirrored.faces.col(1));  // outwards again, as cleaning leaves it
  const auto pairs = everySecond(sphere);
  for (const auto& [target, expected] : {std::pair(turned, 1.0), std::pair(mirrored, -1.0)}) {
    const CommonMeshes meshes = computeCommonMeshes(sphere, target, pairs);
    // The last collapses may fold a sliver over.
    EXPECT_NEAR(orientationVote(meshes.from_source, normalsAt(target, pairs)), expected, 0.01);
  }
}

TEST(OrientationVote, abstainsWithoutFaces) {
  const TriangleMesh sphere = test::sphere(1);
  const CommonMeshes none = computeCommonMeshes(sphere, sphere, {});
  EXPECT_EQ(orientationVote(none.from_source, Points(0, 3)), 0);
}

TEST(OrientationVote, refusesNormalsThatDoNotFit) {
  const TriangleMesh sphere = test::sphere(1);
  const CommonMeshes meshes = computeCommonMeshes(sphere, sphere, everySecond(sphere));
  EXPECT_THROW(orientationVote(meshes.from_source, Points(1, 3)), std::invalid_argument);
}

}  // namespace
}  // namespace posture
