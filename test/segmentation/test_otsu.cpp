// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "otsu.h"
#include <cmath>
#include <limits>

namespace posture {
namespace {

TEST(OtsuThreshold, liesHalfWayBetweenTheTwoClasses) {
  EXPECT_DOUBLE_EQ(otsuThreshold({9, 1, 11, 1.5, 0.5, 10}), 5.25);
  EXPECT_DOUBLE_EQ(otsuThreshold({2, 7}), 4.5);
}

TEST(OtsuThreshold, cutsOffAFewFromMany) {
  std::vector<double> values;
  for (int i = 0; i < 200; ++i) values.push_back(0.01 * (i % 10));
  values.insert(values.end(), {2, 2.2, 2.4});
  EXPECT_DOUBLE_EQ(otsuThreshold(values), 0.5 * (0.09 + 2));
}

TEST(OtsuThreshold, leavesClassesOfLeastVarianceWithin) {
  const std::vector<double> values{0.3, 0.4, 0.9, 1.5, 1.6, 2.4, 4.1, 4.2, 7};
  const auto within = [&](double cut) {
    double sum[2] = {0, 0}, count[2] = {0, 0}, squares = 0;
    for (double x : values) {
      sum[x > cut] += x;
      ++count[x > cut];
    }
    for (double x : values) squares += std::pow(x - sum[x > cut] / count[x > cut], 2);
    return squares;
  };
  const double least = within(otsuThreshold(values));
  for (std::size_t i = 1; i < values.size(); ++i)
    EXPECT_GE(within(0.5 * (values[i - 1] + values[i])), least - 1e-12) << i;
}

TEST(OtsuThreshold, ofFewerThanTwoValuesIsInfinite) {
  EXPECT_EQ(otsuThreshold({}), std::numeric_limits<double>::infinity());
  EXPECT_EQ(otsuThreshold({3}), std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace posture
