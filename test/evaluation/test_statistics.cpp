// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/evaluation/statistics.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace posture {
namespace {

TEST(Statistics, percentile) {
  EXPECT_EQ(percentile({3, 1, 2}, 0.5), 2);
  EXPECT_EQ(percentile({4, 1, 3, 2}, 0.5), 2.5);
  EXPECT_EQ(percentile({4, 1, 3, 2}, 0), 1);
  EXPECT_EQ(percentile({4, 1, 3, 2}, 1), 4);
  EXPECT_EQ(percentile({7}, 0.95), 7);
  EXPECT_TRUE(std::isnan(percentile({}, 0.5)));
}

TEST(Statistics, mean) {
  EXPECT_EQ(mean({1, 2, 6}), 3);
  EXPECT_TRUE(std::isnan(mean({})));
}

TEST(Statistics, largest) {
  EXPECT_EQ(largest({1, 6, 2}), 6);
  EXPECT_TRUE(std::isnan(largest({})));
}

TEST(Statistics, evenSubset) {
  EXPECT_THAT(evenSubset(3, 10), testing::ElementsAre(0, 1, 2));
  EXPECT_THAT(evenSubset(10, 5), testing::ElementsAre(1, 3, 5, 7, 9));
  EXPECT_TRUE(evenSubset(0, 5).empty());
  const auto subset = evenSubset(2'000'000'000, 1000);
  EXPECT_EQ(subset.size(), 1000u);
  EXPECT_LT(subset.back(), 2'000'000'000);
  EXPECT_GT(subset.back(), 1'990'000'000);
}

}  // namespace
}  // namespace posture
