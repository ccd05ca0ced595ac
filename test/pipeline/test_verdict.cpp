// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "answer/verdict.h"
#include <limits>

namespace posture {
namespace {

TEST(IsDecisive, onlyFarWorseScoresAre) {
  constexpr double NONE = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(isDecisive(-9, -8));
  EXPECT_FALSE(isDecisive(-9, -8.01));
  EXPECT_FALSE(isDecisive(-8, -9));
  EXPECT_TRUE(isDecisive(-9, NONE));
  EXPECT_FALSE(isDecisive(NONE, -9));
  EXPECT_FALSE(isDecisive(NONE, NONE)) << "neither has a map";
}

TEST(MayConvince, whatConvincesMayAndWhatIsDecisivelyWorseMayNot) {
  double limit = -20;
  while (convinces(limit)) limit += 0.01;
  EXPECT_TRUE(mayConvince(limit));
  EXPECT_TRUE(mayConvince(limit - 5));
  EXPECT_FALSE(mayConvince(limit + 1.02));
  EXPECT_FALSE(mayConvince(std::numeric_limits<double>::infinity()));
}

}  // namespace
}  // namespace posture
