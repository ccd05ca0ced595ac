// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "noisy/normals.h"
#include "scan_shapes.h"

namespace posture {
namespace {

EstimatedNormals estimate(const Points& points) {
  const NeighborTable neighbors = NeighborSearch(points).table(32);
  return estimateNormals(points, neighbors, spacing(points, neighbors));
}

TEST(Normals, areThoseOfASphere) {
  const Points points = test::spherePoints(4000, 0.003);
  const Points normals = estimate(points).normals;
  for (int i = 0; i < 4000; ++i) {
    EXPECT_NEAR(normals.row(i).norm(), 1, 1e-9);
    EXPECT_GT(std::abs(normals.row(i).dot(points.row(i).normalized())), 0.95);
  }
}

TEST(Normals, doNotMixOpposingSheets) {
  // Sheets 2.5 spacings apart: a ball of three spacings around a point holds much of the other one.
  const Points points =
      test::joined(test::planePoints(4000, 0), test::planePoints(4000, 0.04, 0, 2));
  const Points normals = estimate(points).normals;
  int tilted = 0;
  for (int i = 0; i < 8000; ++i) tilted += std::abs(normals(i, 2)) < 0.95;
  EXPECT_LT(tilted, 80);
}

TEST(Normals, residualIsTheNoise) {
  Points points = test::planePoints(10000, 0);
  Rng rng(2);
  for (int i = 0; i < 10000; ++i) points(i, 2) = 0.002 * rng.normal();
  // Three of the eleven degrees of freedom go into the plane.
  EXPECT_NEAR(estimate(points).residual, 0.002 * std::sqrt(8.0 / 11), 0.0002);
}

}  // namespace
}  // namespace posture
