// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/types.h>

#include <gtest/gtest.h>

#include "joint.h"
#include <cmath>

namespace posture {
namespace {

using Eigen::Vector3d;

/// A round limb along x, from one end to the other.
Stiffness limb(double from, double to, double radius) {
  constexpr int COUNT = 2000;
  Stiffness limb;
  for (int i = 0; i < COUNT; ++i) {
    const double around = 2.4 * i;  // the golden angle
    const Vector3d normal(0, std::cos(around), std::sin(around));
    limb.add(Vector3d(from + (to - from) * (i + 0.5) / COUNT, 0, 0) + radius * normal, normal, 0.5);
  }
  return limb;
}

/// What is found of a turn of the second one, where both move somewhere else besides.
double turnFound(const Stiffness& a,
                 const Stiffness& b,
                 double turn,
                 const Vector3d& axis,
                 double along,
                 bool other_way = false) {
  const Vector3d place(0.1, 0, 0);
  const Eigen::Isometry3d common =
      Eigen::Translation3d(1, 2, -3) * Eigen::AngleAxisd(2, Vector3d(1, -1, 2).normalized());
  const Eigen::Isometry3d own = common * Eigen::Translation3d(place) *
                                Eigen::AngleAxisd(turn, axis.normalized()) *
                                Eigen::Translation3d(-place);
  if (other_way) {
    const Joint joint(place, b.about(place, along), a.about(place, along));
    return joint.turn(joint.cost(own, common));
  }
  const Joint joint(place, a.about(place, along), b.about(place, along));
  return joint.turn(joint.cost(common, own));
}

TEST(Joint, tellsTheTurnFromItsCost) {
  for (const double along : {1.0, 0.01})
    for (const double length : {0.2, 1.0, 5.0})
      for (const double turn : {0.02, 0.2, 0.5}) {
        const Stiffness a = limb(-1, 0.1, 0.1), b = limb(0.1, 0.1 + length, 0.1);
        const double found = turnFound(a, b, turn, {0, 1, 1}, along);
        EXPECT_NEAR(found / turn, 1, 0.01) << length;
        EXPECT_NEAR(turnFound(a, b, turn, {0, 1, 1}, along, true), found, 1e-9);
      }
}

TEST(Joint, takesATwistForLittle) {
  const Stiffness a = limb(-1, 0.1, 0.1), b = limb(0.1, 1.1, 0.1);
  const double seen = turnFound(a, b, 0.2, {1, 0, 0}, 1),
               hardly_seen = turnFound(a, b, 0.2, {1, 0, 0}, 0.01);
  EXPECT_GT(hardly_seen, 0);
  EXPECT_LT(seen, 0.1);
  EXPECT_LT(hardly_seen, 0.2 * seen);
}

TEST(Joint, ofWhatMovesAsOneDoesNotTurn) {
  EXPECT_LT(turnFound(limb(-1, 0.1, 0.1), limb(0.1, 1.1, 0.1), 0, {0, 1, 0}, 1), 1e-5);
}

TEST(Stiffness, isWhatItCostsToMoveOffTheSurface) {
  Stiffness plate;  // in the plane of x and y
  for (int x : {-1, 1})
    for (int y : {-1, 1}) plate.add({double(x), double(y), 3}, {0, 0, 1}, 0.25);
  const Matrix6 m = plate.about({0, 0, 3}, 0.01);
  Vector6 expected;
  expected << 1, 1, 0.02, 0.01, 0.01, 1;  // turns, then shifts
  EXPECT_LT((m - Matrix6(expected.asDiagonal())).norm(), 1e-12);
}

TEST(Joint, isInTheMiddleOfTheBorder) {
  Border border, rest;
  border.add({0, 0, 0}, {2, 0, 0});
  rest.add({2, 0, 0}, {2, 0, 0});  // no length
  rest.add({2, 0, 0}, {2, 2, 0});
  border.add(rest);
  EXPECT_LT((border.middle() - Vector3d(1.5, 0.5, 0)).norm(), 1e-9);
}

}  // namespace
}  // namespace posture
