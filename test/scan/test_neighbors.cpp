// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "points/neighbors.h"
#include "support/shapes.h"
#include <algorithm>
#include <utility>
#include <vector>

namespace posture {
namespace {

TEST(Neighbors, areTheNearestOfAll) {
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

TEST(Neighbors, leaveOutThePointItselfAmongNearlyEqualOnes) {
  Points points = Points::Zero(6, 3);
  for (int i = 0; i < 6; ++i) points(i, 0) = 1 + 1e-12 * i;  // single precision tells none apart
  const NeighborTable table = NeighborSearch(points).table(5);
  for (int i = 0; i < 6; ++i) EXPECT_FALSE((table.row(i).array() == i).any());
}

TEST(Neighbors, areCountedUpToThePadding) {
  NeighborTable table(3, 2);
  table << 1, 2, 0, -1, -1, -1;
  EXPECT_EQ(neighborCount(table, 0), 2);
  EXPECT_EQ(neighborCount(table, 1), 1);
  EXPECT_EQ(neighborCount(table, 2), 0);
}

}  // namespace
}  // namespace posture
