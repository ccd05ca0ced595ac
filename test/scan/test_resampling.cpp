// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "noisy/resampling.h"
#include "scan_shapes.h"

namespace posture {
namespace {

Points noisyPlane(int count, double noise) {
  Points points = test::planePoints(count, 0);
  Rng rng(6);
  for (int i = 0; i < count; ++i) points(i, 2) = noise * rng.normal();
  return points;
}

int neighborsNeeded(const Points& points) {
  return noiseScale(points, NeighborSearch(points)).neighbors;
}

TEST(NoiseScale, growsWithTheNoise) {
  EXPECT_EQ(neighborsNeeded(noisyPlane(20000, 0)), 10);
  // A disc of k points has a radius of sqrt(k / pi) spacings, of which the noise may be a fifth: 50
  // points at 0.8 spacings, fewer as neighbours are sought in a ball and the plane is fitted.
  const double h = 1 / std::sqrt(20000.0);
  EXPECT_EQ(neighborsNeeded(noisyPlane(20000, 0.2 * h)), 10);
  EXPECT_THAT(neighborsNeeded(noisyPlane(20000, 0.8 * h)), testing::AnyOf(40, 80));
  EXPECT_THAT(neighborsNeeded(noisyPlane(20000, 1.6 * h)), testing::AnyOf(160, 320));
}

TEST(NoiseScale, knowsViewsThatDoNotFit) {
  // Two layers whose distance is more than neighbourhoods within one can bridge.
  Points points = test::joined(test::planePoints(2000, 0), test::planePoints(2000, 0.15, 0, 2));
  EXPECT_FALSE(noiseScale(points, NeighborSearch(points)).double_walls);
  Rng rng(9);
  Points solid(4000, 3);
  for (int i = 0; i < solid.size(); ++i) solid.data()[i] = rng.uniform();
  EXPECT_TRUE(noiseScale(solid, NeighborSearch(solid)).double_walls);
}

TEST(NoiseScale, fewPointsSayNothingOfViews) {
  const Points points = test::planePoints(100, 0);
  EXPECT_FALSE(noiseScale(points, NeighborSearch(points)).double_walls);
}

TEST(Cells, holdTheMeanOfTheirPoints) {
  Points points(4, 3);
  points << 0.1, 0, 0, 2.5, 0, 0, 0.3, 0, 0, -0.1, 0, 0;
  const Cells cells = averageInCells(points, 1);
  EXPECT_EQ(cells.cell, (std::vector<int>{0, 1, 0, 2}));
  EXPECT_NEAR(cells.means(0, 0), 0.2, 1e-12);
  EXPECT_NEAR(cells.means(2, 0), -0.1, 1e-12);
}

}  // namespace
}  // namespace posture
