// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/rng.h>
#include <posture/matching/consistency.h>

#include <gtest/gtest.h>

#include "support/shapes.h"
#include <algorithm>
#include <cmath>
#include <limits>

namespace posture {
namespace {

using test::pairwise;

std::vector<Match> identity(int count) {
  std::vector<Match> matches;
  for (int i = 0; i < count; ++i) matches.push_back({i, i});
  return matches;
}

TEST(LengthConsistency, isTheSmallerRatio) {
  EXPECT_DOUBLE_EQ(lengthConsistency(2, 4), 0.5);
  EXPECT_DOUBLE_EQ(lengthConsistency(4, 2), 0.5);
  EXPECT_DOUBLE_EQ(lengthConsistency(3, 3), 1);
  EXPECT_EQ(lengthConsistency(0, 3), 0);
  EXPECT_EQ(lengthConsistency(0, 0), 0);
  EXPECT_EQ(lengthConsistency(1, std::numeric_limits<double>::infinity()), 0);
}

TEST(ConsistencyMatrix, isOneForAnIsometryAndTheRatioForAStretch) {
  const Matrix distances = pairwise(Points::Random(12, 3));
  EXPECT_LT((consistencyMatrix(identity(12), distances, distances) - Matrix::Ones(12, 12)).norm(),
            1e-12);
  const Matrix stretched = consistencyMatrix(identity(12), distances, 1.25 * distances);
  for (int i = 0; i < 12; ++i)
    for (int j = 0; j < 12; ++j) EXPECT_NEAR(stretched(i, j), i == j ? 1 : 0.8, 1e-12);
}

TEST(ConsistencyThreshold, learnsTheGaussianMirroredAtOne) {
  // Entries 1 - |x|, x normal with deviation 0.05: mirrored at 1 they are normal about 1.
  Rng rng(1);
  std::vector<Matrix> matrices;
  for (int k = 0; k < 8; ++k) {
    Matrix c = Matrix::Ones(100, 100);
    for (int i = 0; i < 100; ++i)
      for (int j = 0; j < i; ++j) c(i, j) = c(j, i) = 1 - std::abs(0.05 * rng.normal());
    matrices.push_back(c);
  }
  // 40,000 draws know the deviation to 0.05 / sqrt(80,000).
  EXPECT_NEAR(consistencyThreshold(matrices), 1 - 3 * 0.05, 3 * 4 * 0.05 / std::sqrt(80000.0));
}

TEST(ConsistencyThreshold, isNeverNegative) {
  Matrix c = Matrix::Zero(5, 5);
  c.diagonal().setOnes();
  EXPECT_EQ(consistencyThreshold({c}), 0);
}

TEST(ConsistencyThreshold, leavesRoomForAPerfectIsometry) {
  const Matrix c = Matrix::Ones(6, 6);
  EXPECT_LT(consistencyThreshold({c}), 1);
  EXPECT_EQ(consistencyKernel(c, consistencyThreshold({c})).size(), 6);
}

TEST(ConsistencyKernel, keepsTheConsistentAndDropsTheRest) {
  Rng rng(2);
  Points source(80, 3);
  for (int i = 0; i < source.size(); ++i) source.data()[i] = rng.normal();
  Points target = source;
  std::vector<int> wrong;
  for (int i = 0; i < 80; i += 8) {
    target.row(i) += Eigen::RowVector3d(6, -5, 7 + i);
    wrong.push_back(i);
  }
  const Matrix c = consistencyMatrix(identity(80), pairwise(source), pairwise(target));
  const std::vector<int> kernel = consistencyKernel(c, 0.7);
  EXPECT_EQ(kernel.size(), 80 - wrong.size());
  for (int i : wrong) EXPECT_EQ(std::count(kernel.begin(), kernel.end(), i), 0) << i;
}

TEST(ConsistencyKernel, isMutuallyConsistent) {
  Rng rng(3);
  Matrix c = Matrix::Ones(40, 40);
  for (int i = 0; i < 40; ++i)
    for (int j = 0; j < i; ++j) c(i, j) = c(j, i) = rng.uniform();
  const std::vector<int> kernel = consistencyKernel(c, 0.4);
  ASSERT_FALSE(kernel.empty());
  for (int i : kernel)
    for (int j : kernel) EXPECT_TRUE(i == j || c(i, j) > 0.4);
}

}  // namespace
}  // namespace posture
