// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "points/outliers.h"
#include "scan_shapes.h"
#include "support/shapes.h"
#include <numeric>

namespace posture {
namespace {

std::vector<char> kept(const Points& points) {
  const NeighborTable neighbors = NeighborSearch(points).table(16);
  return withoutOutliers(points, neighbors, spacing(points, neighbors));
}

std::vector<char> keptOfClean(const Points& points) {
  const NeighborTable neighbors = NeighborSearch(points).table(16);
  return withoutStrays(points, neighbors, spacing(points, neighbors));
}

TEST(Outliers, goAndTheSurfaceStays) {
  Rng rng(4);
  Points wild(400, 3);
  for (int i = 0; i < wild.size(); ++i) wild.data()[i] = 3 * rng.uniform() - 1.5;
  const std::vector<char> keep = kept(test::joined(test::spherePoints(4000, 0.003), wild));
  EXPECT_GE(std::accumulate(keep.begin(), keep.begin() + 4000, 0), 3998);
  int far_kept = 0;
  for (int i = 0; i < 400; ++i)
    far_kept += keep[4000 + i] && std::abs(wild.row(i).norm() - 1) > 0.3;  // six spacings
  EXPECT_EQ(far_kept, 0);
}

TEST(Outliers, sparsePartsOfASurfaceAreNone) {
  // A quarter of the density: spacings twice as large, then sixteen times fewer points: four times.
  Points sparse = test::planePoints(600, 0, 0, 2);
  sparse.col(0).array() += 1;
  const std::vector<char> keep = kept(test::joined(test::planePoints(15000, 0), sparse));
  EXPECT_GE(std::accumulate(keep.end() - 600, keep.end(), 0), 570);
}

TEST(Outliers, smallGroupsGo) {
  Points group = 0.03 * test::spherePoints(20, 0);
  group.col(2).array() += 2;
  const std::vector<char> keep = kept(test::joined(test::spherePoints(4000, 0), group));
  EXPECT_EQ(std::accumulate(keep.end() - 20, keep.end(), 0), 0);
}

TEST(Strays, goAndCoarsePartsStay) {
  // Rings 0.7 apart, and a part of it coarse all around, beside a ball whose points are 0.04 apart.
  Points limb = test::coarseLimb(40, 12, 0.25, 0.7), sparse = test::planePoints(100, 0, 0, 2);
  limb.col(0).array() += 4;
  sparse *= 4;
  sparse.col(1).array() += 4;
  const Points body = test::joined(test::joined(test::spherePoints(8000, 0), limb), sparse);
  Rng rng(4);
  Points wild(400, 3);
  for (int i = 0; i < wild.size(); ++i) wild.data()[i] = 3 * rng.uniform() - 1.5;
  const std::vector<char> keep = keptOfClean(test::joined(body, wild));
  // The limb is closed by two points far from all others.
  EXPECT_GE(std::accumulate(keep.begin(), keep.begin() + body.rows(), 0), body.rows() - 2);
  int far_kept = 0;
  for (int i = 0; i < 400; ++i)
    far_kept += keep[body.rows() + i] && std::abs(wild.row(i).norm() - 1) > 0.28;  // seven spacings
  // One in a hundred has three others within five spacings by chance.
  EXPECT_LE(far_kept, 8);
}

}  // namespace
}  // namespace posture
