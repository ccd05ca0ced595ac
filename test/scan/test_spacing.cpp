// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/median.h>

#include <gtest/gtest.h>

#include "points/neighbors.h"
#include "points/spacing.h"
#include "scan_shapes.h"
#include <utility>
#include <vector>

namespace posture {
namespace {

TEST(Spacing, isTheSideOfTheSquareOfAPoint) {
  const Points points = test::planePoints(10000, 0);
  EXPECT_NEAR(spacing(points, NeighborSearch(points).table(16)).median, 0.01, 0.001);
}

TEST(Spacing, followsTheDensity) {
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
