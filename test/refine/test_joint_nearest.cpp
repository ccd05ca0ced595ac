// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/rng.h>

#include <gtest/gtest.h>

#include "joint_nearest.h"
#include <limits>
#include <vector>

namespace posture {
namespace {

Eigen::MatrixXf randomRows(int rows, int columns, std::uint64_t seed) {
  Rng rng(seed);
  Eigen::MatrixXf m(rows, columns);
  for (float& x : m.reshaped()) x = static_cast<float>(rng.normal());
  return m;
}

/// In double precision, one by one.
int nearestRow(const Eigen::MatrixXf& rows, const Eigen::RowVectorXf& to) {
  Eigen::Index nearest = 0;
  (rows.cast<double>().rowwise() - to.cast<double>()).rowwise().squaredNorm().minCoeff(&nearest);
  return static_cast<int>(nearest);
}

TEST(NearestBothWays, findsWhatLookingAtAllFinds) {
  // Fewer rows than one block of products, and more than two.
  for (int rows : {1, 40, 150}) {
    const Eigen::MatrixXf a = randomRows(90, 6, 1), b = randomRows(rows, 6, 2);
    std::vector<int> forward, backward;
    nearestBothWays(a, b, forward, backward);
    ASSERT_EQ(forward.size(), 90U);
    ASSERT_EQ(backward.size(), static_cast<std::size_t>(rows));
    for (int i = 0; i < 90; ++i) EXPECT_EQ(forward[i], nearestRow(b, a.row(i))) << i;
    for (int j = 0; j < rows; ++j) EXPECT_EQ(backward[j], nearestRow(a, b.row(j))) << j;
  }
}

TEST(NearestBothWays, takesTheFirstOfEquallyNearRows) {
  // Small integers: all distances are exact.
  Eigen::MatrixXf a(100, 1), b(130, 1);
  for (int i = 0; i < 100; ++i) a(i, 0) = static_cast<float>(i % 5);
  for (int j = 0; j < 130; ++j) b(j, 0) = static_cast<float>(j % 5);
  std::vector<int> forward, backward;
  nearestBothWays(a, b, forward, backward);
  for (int i = 0; i < 100; ++i) EXPECT_EQ(forward[i], i % 5);
  for (int j = 0; j < 130; ++j) EXPECT_EQ(backward[j], j % 5);
}

Eigen::MatrixXf without(const Eigen::MatrixXf& rows, int gone) {
  Eigen::MatrixXf rest(rows.rows() - 1, rows.cols());
  rest << rows.topRows(gone), rows.bottomRows(rows.rows() - 1 - gone);
  return rest;
}

TEST(NearestBothWays, aRowThatIsNoNumberGetsARowAndIsAsGoodAsNotThereForOthers) {
  constexpr int A = 80, B = 70;
  for (int bad = 0; bad < 16; ++bad) {
    Eigen::MatrixXf a = randomRows(A, 3, 3), b = randomRows(B, 3, 4);
    // Whether it is in `a` or in `b`: both ways are compared.
    for (const bool in_a : {true, false}) {
      std::vector<int> to_bad, from_bad, to_rest, from_rest;
      const Eigen::MatrixXf rest = without(in_a ? a : b, bad);
      Eigen::MatrixXf& rows = in_a ? a : b;
      const Eigen::MatrixXf before = rows;
      rows.row(bad).setConstant(std::numeric_limits<float>::quiet_NaN());
      if (in_a) {
        nearestBothWays(a, b, from_bad, to_bad);
        nearestBothWays(rest, b, from_rest, to_rest);
      } else {
        nearestBothWays(a, b, to_bad, from_bad);
        nearestBothWays(a, rest, to_rest, from_rest);
      }
      rows = before;
      ASSERT_EQ(to_bad.size(), to_rest.size());
      for (std::size_t i = 0; i < to_bad.size(); ++i)
        EXPECT_EQ(to_bad[i], to_rest[i] + (to_rest[i] >= bad)) << bad << " " << i;
      EXPECT_TRUE(from_bad[bad] >= 0 && from_bad[bad] < static_cast<int>(to_bad.size()));
      from_bad.erase(from_bad.begin() + bad);
      EXPECT_EQ(from_bad, from_rest) << bad;
    }
  }
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
