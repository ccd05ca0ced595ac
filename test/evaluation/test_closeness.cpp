// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/evaluation/closeness.h>

#include <gtest/gtest.h>

#include "support/shapes.h"
#include <cmath>
#include <limits>

namespace posture {
namespace {

TEST(Closeness, nearIsWithinTheSideOfAGridsSquares) {
  for (const double side : {0.1, 100.0}) {
    const Points target = test::grid(40, 40, 40 * side, 40 * side).vertices;
    Points near = target, far = target;
    near.col(2).array() += 0.9 * side;
    far.col(2).array() += 1.1 * side;
    EXPECT_EQ(measureCloseness(near, target).moved_near, 1);
    EXPECT_EQ(measureCloseness(near, target).target_near, 1);
    EXPECT_EQ(measureCloseness(far, target).moved_near, 0);
  }
}

TEST(Closeness, nothingIsMissingOfAShapeOnItself) {
  const Points sphere = test::sphere(3).vertices;
  const Closeness close = measureCloseness(sphere, sphere);
  EXPECT_NEAR(close.mean_distance, 0, 1e-6);
  EXPECT_EQ(close.moved_near, 1);
  EXPECT_EQ(close.target_near, 1);
}

TEST(Closeness, halfAShapeCoversHalfOfTheOther) {
  const Points whole = test::grid(40, 20, 4, 2).vertices;
  Points half = test::grid(20, 20, 2, 2).vertices;
  EXPECT_EQ(measureCloseness(half, whole).moved_near, 1);
  EXPECT_NEAR(measureCloseness(half, whole).target_near, 0.5, 0.05);
  half.row(3).setConstant(std::numeric_limits<double>::quiet_NaN());  // not seen
  EXPECT_EQ(measureCloseness(half, whole).moved_near, 1);
}

TEST(Closeness, onePointFarOutIsNoSize) {
  const Points target = test::grid(30, 40, 3, 4).vertices;
  Points moved = target, wild = target;
  moved.col(2).array() += 0.1;
  wild.row(100).setConstant(1e6);
  EXPECT_NEAR(measureCloseness(moved, wild).mean_distance,
              measureCloseness(moved, target).mean_distance,
              1e-3);
}

TEST(Closeness, distanceIsInDiagonals) {
  const Points target = 50 * test::grid(30, 40, 3, 4).vertices;  // diagonal 250
  Points lifted = target;
  lifted.col(2).array() += 25;
  const Closeness close = measureCloseness(lifted, target);
  EXPECT_NEAR(close.mean_distance, 0.1, 1e-6);
  EXPECT_EQ(close.moved_near, 0);
  EXPECT_EQ(close.target_near, 0);
}

TEST(Closeness, refusesNoPoints) {
  const Points none = Points::Constant(4, 3, std::nan(""));
  EXPECT_THROW(measureCloseness(none, test::sphere(1).vertices), std::invalid_argument);
  EXPECT_THROW(measureCloseness(test::sphere(1).vertices, none), std::invalid_argument);
}

}  // namespace
}  // namespace posture
