// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/types.h>

#include <gtest/gtest.h>

#include "joint.h"
#include "moments.h"
#include <cmath>

namespace posture {
namespace {

using Eigen::Vector3d;

/// Places all over a round limb along x, from one end to the other.
Points limb(double from, double to, double radius) {
  constexpr int COUNT = 2000;
  Points places(COUNT, 3);
  for (int i = 0; i < COUNT; ++i) {
    const double around = 2.4 * i;  // the golden angle
    places.row(i) << from + (to - from) * (i + 0.5) / COUNT, radius * std::cos(around),
        radius * std::sin(around);
  }
  return places;
}

struct Bodies {
  Mass mass[2];
  Moments together, apart[2];

  /// The second one turns by `turn` about an axis through `joint`, both by something else besides.
  Bodies(
      const Points& a, const Points& b, double turn, const Vector3d& axis, const Vector3d& joint) {
    const Eigen::Isometry3d common =
        Eigen::Translation3d(1, 2, -3) * Eigen::AngleAxisd(2, Vector3d(1, -1, 2).normalized());
    const Eigen::Isometry3d own = common * Eigen::Translation3d(joint) *
                                  Eigen::AngleAxisd(turn, axis.normalized()) *
                                  Eigen::Translation3d(-joint);
    const Points* places[] = {&a, &b};
    for (int k = 0; k < 2; ++k)
      for (const auto& row : places[k]->rowwise()) {
        const Vector3d p = row;
        mass[k].add(p, 0.5);
        apart[k].add(p, (k == 0 ? common : own) * p, 0.5);
      }
    together.add(apart[0]);
    together.add(apart[1]);
  }

  double cost() const { return together.misfit() - apart[0].misfit() - apart[1].misfit(); }
};

TEST(Joint, TellsTheTurnFromItsCost) {
  const Vector3d joint(0, 0, 0);
  for (const double length : {0.2, 1.0, 5.0})
    for (const double turn : {0.02, 0.2, 0.5}) {
      const Bodies bodies(limb(-1, 0, 0.1), limb(0, length, 0.1), turn, {0, 1, 1}, joint);
      const double found = turnOf(bodies.mass[0], bodies.mass[1], joint, bodies.cost());
      EXPECT_NEAR(found / turn, 1, 0.1) << length;
      const double other_way = turnOf(bodies.mass[1], bodies.mass[0], joint, bodies.cost());
      EXPECT_NEAR(other_way, found, 1e-9);
    }
}

TEST(Joint, TakesATwistForLittle) {
  const Vector3d joint(0, 0, 0);
  const Bodies bodies(limb(-1, 0, 0.1), limb(0, 1, 0.1), 0.2, {1, 0, 0}, joint);
  const double found = turnOf(bodies.mass[0], bodies.mass[1], joint, bodies.cost());
  EXPECT_GT(found, 0);
  EXPECT_LT(found, 0.1);
}

TEST(Joint, OfWhatMovesAsOneDoesNotTurn) {
  const Vector3d joint(0, 0, 0);
  const Bodies bodies(limb(-1, 0, 0.1), limb(0, 1, 0.1), 0, {0, 1, 0}, joint);
  EXPECT_LT(turnOf(bodies.mass[0], bodies.mass[1], joint, std::max(0.0, bodies.cost())), 1e-5);
}

TEST(Joint, IsInTheMiddleOfTheBorder) {
  Border border, rest;
  border.add({0, 0, 0}, {2, 0, 0});
  rest.add({2, 0, 0}, {2, 0, 0});  // no length
  rest.add({2, 0, 0}, {2, 2, 0});
  border.add(rest);
  EXPECT_LT((border.middle() - Vector3d(1.5, 0.5, 0)).norm(), 1e-9);
}

}  // namespace
}  // namespace posture
