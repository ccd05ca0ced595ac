// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/rng.h>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "clean/predicates.h"
#include <utility>

namespace posture {
namespace {

TEST(Predicates, agreeWithIntegers) {
  // Small enough for products of five in 64 bits; a third of them are degenerate.
  Rng rng(6);
  const auto place = [&] {
    LatticePoint p;
    for (double& x : p) x = rng.below(5);
    return p;
  };
  const auto minus = [](const LatticePoint& p, const LatticePoint& q) {
    return Eigen::Matrix<long long, 3, 1>(static_cast<long long>(p[0] - q[0]),
                                          static_cast<long long>(p[1] - q[1]),
                                          static_cast<long long>(p[2] - q[2]));
  };
  int degenerate = 0;
  for (int trial = 0; trial < 3000; ++trial) {
    const LatticePoint a = place(), b = place(), c = place(), d = place(), e = place();
    const long long turn = minus(b, a).cross(minus(c, a)).dot(minus(d, a));
    ASSERT_EQ(orientation(a, b, c, d), (turn > 0) - (turn < 0));
    if (turn <= 0) continue;
    if (e == a || e == b || e == c || e == d) continue;
    Eigen::Matrix<long long, 4, 4> m;
    int row = 0;
    for (const LatticePoint* p : {&a, &b, &c, &d}) {
      const auto v = minus(*p, e);
      m.row(row++) << v.transpose(), v.squaredNorm();
    }
    long long lifted = 0;
    for (int k = 0; k < 4; ++k) {
      Eigen::Matrix<long long, 3, 3> minor;
      for (int r = 0, to = 0; r < 4; ++r)
        if (r != k) minor.row(to++) = m.row(r).head<3>();
      const long long of_three = minor.row(0).cross(minor.row(1)).dot(minor.row(2));
      lifted += (k % 2 == 0 ? 1 : -1) * m(k, 3) * of_three;
    }
    degenerate += lifted == 0;
    if (lifted != 0) {
      ASSERT_EQ(isInSphere(a, b, c, d, e), lifted > 0);
    }
  }
  EXPECT_GT(degenerate, 20);
}

TEST(Predicates, areExactWhereRoundingIsNot) {
  // Nearly in a plane: the last place of coordinates of 51 bits decides.
  const double far = 0x1p51 - 1;
  EXPECT_EQ(orientation({0, 0, 0}, {far, 0, 1}, {0, far, 1}, {far, far, 2}), 0);
  EXPECT_EQ(orientation({0, 0, 0}, {far, 0, 1}, {0, far, 1}, {far, far, 3}), 1);
  EXPECT_EQ(orientation({0, 0, 0}, {far, 0, 1}, {0, far, 1}, {far - 1, far, 2}), 1);
  // The same of a sphere, and beside the corners of its octahedron.
  const double radius = 0x1p50;
  LatticePoint a{radius, 0, 0}, b{0, radius, 0};
  const LatticePoint c{0, 0, radius}, d{-radius, 0, 0};
  if (orientation(a, b, c, d) < 0) std::swap(a, b);
  ASSERT_EQ(orientation(a, b, c, d), 1);
  EXPECT_TRUE(isInSphere(a, b, c, d, {0, 0, 1 - radius}));
  EXPECT_FALSE(isInSphere(a, b, c, d, {0, 0, -1 - radius}));
  EXPECT_TRUE(isInSphere(a, b, c, d, {0, 1 - radius, 0}));
  EXPECT_FALSE(isInSphere(a, b, c, d, {1, -radius, 0}));
}

}  // namespace
}  // namespace posture
