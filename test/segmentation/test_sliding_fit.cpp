// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "moments.h"
#include "sliding_fit.h"
#include "support/shapes.h"
#include <cmath>

namespace posture {
namespace {

using Eigen::Vector3d;

constexpr double DEGREE = M_PI / 180;

/// An ellipsoid, and the same moved, its vertices turned along its surface besides.
struct Slid {
  TriangleMesh rest = test::sphere(4);
  Points places;
  Eigen::Isometry3d motion =
      Eigen::Translation3d(1, -2, 3) * Eigen::AngleAxisd(0.5, Vector3d(1, 2, -1).normalized());
  std::vector<WeighedVertex> all;

  explicit Slid(double angle) {
    const Eigen::Matrix3d axes = Vector3d(1, 0.8, 0.6).asDiagonal();
    const Eigen::Matrix3d along(Eigen::AngleAxisd(angle, Vector3d(1, 1, 1).normalized()));
    places = rest.vertices;
    for (int v = 0; v < places.rows(); ++v) {
      const Vector3d at = rest.vertices.row(v);
      places.row(v) = motion * (axes * (along * at));
      rest.vertices.row(v) = axes * at;
      all.push_back({v, 1});
    }
  }

  double off(const Eigen::Isometry3d& found) const {
    return Eigen::AngleAxisd(found.linear() * motion.linear().transpose()).angle() / DEGREE;
  }

  Eigen::Isometry3d asTheVerticesSay() const {
    Moments moments;
    for (int v = 0; v < places.rows(); ++v) moments.add(rest.vertices.row(v), places.row(v), 1);
    return moments.motion();
  }
};

TEST(SlidingFit, goesByTheSurface) {
  const Slid slid(10 * DEGREE);
  const PosedSurface surface(slid.places, slid.rest.faces);
  const Eigen::Isometry3d start = slid.asTheVerticesSay();
  EXPECT_GT(slid.off(start), 8);
  const SlidingFit fit =
      slideOnto(surface, slid.rest.vertices, slid.all, start, {0.001, 50, false});
  EXPECT_LT(slid.off(fit.motion), 1);
}

TEST(SlidingFit, staysWhereTheVerticesAreRight) {
  const Slid right(0);
  const PosedSurface surface(right.places, right.rest.faces);
  for (bool robust : {false, true}) {
    const SlidingFit fit =
        slideOnto(surface, right.rest.vertices, right.all, right.motion, {0.01, 8, robust});
    EXPECT_LT((fit.motion.matrix() - right.motion.matrix()).norm(), 1e-9);
    EXPECT_LT(fit.misfit, 1e-12);
  }
}

TEST(SlidingFit, doesNotFollowTheFew) {
  Slid slid(0);
  Points bent = slid.places;
  for (int v = 0; v < bent.rows(); ++v)
    if (slid.rest.vertices(v, 0) > 0.7) bent(v, 0) += 0.5 * (slid.rest.vertices(v, 0) - 0.7);
  const PosedSurface surface(bent, slid.rest.faces);
  const auto found = [&](bool robust) {
    return slideOnto(surface, slid.rest.vertices, slid.all, slid.motion, {0.01, 30, robust}).motion;
  };
  EXPECT_GT((found(false).matrix() - slid.motion.matrix()).norm(), 1e-3);
  EXPECT_LT((found(true).matrix() - slid.motion.matrix()).norm(), 1e-6);
}

TEST(SlidingFit, endsWhereAPlaceIsNoNumber) {
  const TriangleMesh ball = test::sphere(1);
  const PosedSurface surface(ball.vertices, ball.faces);
  int from = 5;
  surface.nearest(Vector3d::Constant(std::nan("")), from);
  EXPECT_EQ(from, 5);
}

}  // namespace
}  // namespace posture
