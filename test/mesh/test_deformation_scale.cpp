// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/mesh/deformation_scale.h>
#include <posture/mesh/edges.h>

#include <gtest/gtest.h>

#include "support/shapes.h"

namespace posture {
namespace {

TEST(DeformationScale, medianRatioIsThatOfMostEdges) {
  const TriangleMesh mesh = test::sphere(2);
  Points places = 2.5 * mesh.vertices;
  places.row(7) << 9, 9, 9;
  EXPECT_NEAR(medianEdgeRatio(mesh, places), 2.5, 1e-12);
  EXPECT_EQ(medianEdgeRatio({mesh.vertices, Faces(0, 3)}, places), 1);
}

TEST(DeformationScale, scaleIsNotThatOfNoise) {
  const TriangleMesh mesh = test::sphere(4);
  const Points noise =
      0.2 * meanEdgeLength(mesh) * test::randomPoints(static_cast<int>(mesh.vertices.rows()), 3);
  const Points noisy = 2.5 * (mesh.vertices + noise);
  EXPECT_GT(medianEdgeRatio(mesh, noisy), 2.5 * 1.005);
  EXPECT_NEAR(scaleWithoutNoise(mesh, noisy), 2.5, 2.5 * 0.002);
}

}  // namespace
}  // namespace posture
