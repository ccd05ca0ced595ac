// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/median.h>

#include <gtest/gtest.h>

#include "points/neighbors.h"
#include "points/spacing.h"
#include "scan_shapes.h"
#include "support/shapes.h"
#include <algorithm>

namespace posture {
namespace {

TEST(Neighbors, AreTheNearestOfAll) {
  const Points points = test::randomPoints(300, 5);
  const Matrix distances = test::pairwise(points);
  const NeighborTable table = NeighborSearch(points).table(7);
  for (int i = 0; i < 300; ++i) {
    std::vector<std::pair<double, int>> order;
    for (int j = 0; j < 300; ++j)
      if (j != i) order.emplace_back(distances(i, j), j);
    std::sort(order.begin(), order.end());
    for (int k = 0; k < 7; ++k) EXPECT_NEAR(distances(i, table(i, k)), order[k].first, 1e-6);
  }
}

TEST(Neighbors, LeaveOutThePointItselfAmongNearlyEqualOnes) {
  Points points = Points::Zero(6, 3);
  for (int i = 0; i < 6; ++i) points(i, 0) = 1 + 1e-12 * i;  // single precision tells none apart
  const NeighborTable table = NeighborSearch(points).table(5);
  for (int i = 0; i < 6; ++i) EXPECT_FALSE((table.row(i).array() == i).any());
}

TEST(Neighbors, AreCountedUpToThePadding) {
  NeighborTable table(3, 2);
  table << 1, 2, 0, -1, -1, -1;
  EXPECT_EQ(neighborCount(table, 0), 2);
  EXPECT_EQ(neighborCount(table, 1), 1);
  EXPECT_EQ(neighborCount(table, 2), 0);
}

TEST(Spacing, IsTheSideOfTheSquareOfAPoint) {
  const Points points = test::planePoints(10000, 0);
  EXPECT_NEAR(spacing(points, NeighborSearch(points).table(16)).median, 0.01, 0.001);
}

TEST(Spacing, FollowsTheDensity) {
  Points sparse = test::planePoints(1000, 0, 0, 2);
  sparse.col(0).array() += 2;
  const Points points = test::joined(test::planePoints(16000, 0), sparse);
  const Spacing h = spacing(points, NeighborSearch(points).table(16));
  std::vector<double> dense_part(h.at.begin(), h.at.begin() + 16000),
      sparse_part(h.at.begin() + 16000, h.at.end());
  EXPECT_NEAR(median(std::move(sparse_part)) / median(std::move(dense_part)), 4, 0.5);
}

}  // namespace
}  // namespace posture
