// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/mesh/areas.h>

#include <gtest/gtest.h>

#include "support/shapes.h"
#include <cmath>

namespace posture {
namespace {

TEST(Areas, ofASurfaceAreThoseOfItsFacesTogether) {
  const TriangleMesh grid = test::grid(4, 3, 2, 8);
  EXPECT_DOUBLE_EQ(surfaceArea(grid), 16);
  EXPECT_DOUBLE_EQ(rootArea(grid), 4);
  EXPECT_EQ(surfaceArea({grid.vertices, Faces(0, 3)}), 0);
}

TEST(Coarseness, tellsDensityAndNotSize) {
  TriangleMesh mesh = test::grid(10, 10, 1, 1);
  EXPECT_NEAR(coarseness(mesh), std::sqrt(0.02), 1e-12);
  mesh.vertices *= 1000;
  EXPECT_NEAR(coarseness(mesh), std::sqrt(0.02), 1e-12);
  EXPECT_NEAR(coarseness(test::grid(5, 5, 1, 1)) / coarseness(mesh), 2, 1e-12);
  // Large faces count, not many small ones.
  TriangleMesh uneven = mesh;
  uneven.vertices.col(0) = mesh.vertices.col(0).cwiseAbs2() / 1000;
  EXPECT_GT(coarseness(uneven), 1.1 * coarseness(mesh));
}

}  // namespace
}  // namespace posture
