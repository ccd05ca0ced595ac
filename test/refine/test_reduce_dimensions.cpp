// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/rng.h>

#include <gtest/gtest.h>

#include "reduce_dimensions.h"

namespace posture {
namespace {

Eigen::MatrixXf randomRows(int rows, int columns, std::uint64_t seed) {
  Rng rng(seed);
  Eigen::MatrixXf m(rows, columns);
  for (float& x : m.reshaped()) x = static_cast<float>(rng.normal());
  return m;
}

TEST(ReduceDimensions, keepsDistancesBetweenTheRowsOfBothWhereTheyLieInASubspace) {
  const Eigen::MatrixXf spread = randomRows(4, 20, 5);
  Eigen::MatrixXf a = randomRows(100, 4, 6) * spread, b = randomRows(50, 4, 7) * spread;
  const Eigen::MatrixXf before_a = a, before_b = b;
  reduceDimensions(a, b, 4);
  ASSERT_EQ(a.cols(), 4);
  ASSERT_EQ(b.cols(), 4);
  for (int i = 0; i < 50; ++i) {
    const float before = (before_a.row(i) - before_b.row(49 - i)).norm();
    EXPECT_NEAR((a.row(i) - b.row(49 - i)).norm(), before, 1e-4f * before);
  }
  reduceDimensions(a, b, 7);
  EXPECT_EQ(a.cols(), 4) << "there are no more";
}

}  // namespace
}  // namespace posture
