// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "cleanness_of.h"
#include "scan_shapes.h"

namespace posture {
namespace {

using test::cleannessOf;

TEST(Cleanness, tellsNoiseFromCoarseness) {
  EXPECT_TRUE(cleannessOf(test::spherePoints(3000, 0)).is_clean);
  EXPECT_TRUE(cleannessOf(test::torusPoints(1000, 1, 0.3)).is_clean);
  EXPECT_TRUE(cleannessOf(test::withBall(test::coarseLimb(6, 60, 0.1, 0.15))).is_clean);
  // A spacing of 0.065.
  EXPECT_FALSE(cleannessOf(test::spherePoints(3000, 0.003)).is_clean);
  EXPECT_FALSE(cleannessOf(test::spherePoints(3000, 0.02)).is_clean);
  EXPECT_NEAR(cleannessOf(test::spherePoints(3000, 0.003)).noise, 0.046, 0.01);
}

TEST(Cleanness, knowsNoiseThatIsNotEverywhereTheSame) {
  // 0.02 spacings on one ball, 0.2 on the other.
  Points beside = test::spherePoints(3000, 0.015, 2);
  beside.col(0).array() += 4;
  const Cleanness found = cleannessOf(test::joined(test::spherePoints(3000, 0.0015), beside));
  EXPECT_LT(found.noise, 0.04);
  EXPECT_FALSE(found.is_clean);
}

}  // namespace
}  // namespace posture
