// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/deformation/follow_matches.h>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "support/motions.h"
#include "support/shapes.h"
#include <cmath>

namespace posture {
namespace {

TEST(FollowMatches, carriesARigidMotionToEverything) {
  const TriangleMesh sphere = test::sphere(3);
  const int n = static_cast<int>(sphere.vertices.rows());
  const auto moved = [](const Points& p) { return test::moved(p, test::motion(0.8)); };
  std::vector<char> known(n, 0);
  for (int v = 0; v < n; v += 3) known[v] = 1;
  Points extra(3, 3);
  extra << 0.1, 0.2, 0.3, -1, 0.5, 2, 0, 0, 0;
  const Points result = followMatches(sphere, known, moved(sphere.vertices), extra, {5, 5, 8});
  EXPECT_LT((result.topRows(n) - moved(sphere.vertices)).norm(), 1e-9);
  EXPECT_LT((result.bottomRows(3) - moved(extra)).norm(), 1e-9);
}

TEST(FollowMatches, eachHalfOfAHingeFollowsItsOwnMatches) {
  const TriangleMesh sheet = test::grid(40, 10, 2, 0.5);
  const int n = static_cast<int>(sheet.vertices.rows());
  const Eigen::Translation3d to_hinge(1, 0, 0);
  const auto motion = [&](double x) -> Eigen::Isometry3d {
    return to_hinge * Eigen::AngleAxisd(x < 1 ? 0.4 : -0.9, Eigen::Vector3d::UnitY()) *
           to_hinge.inverse();
  };
  Points places(n, 3);
  std::vector<char> known(n);
  int anchor[2] = {-1, -1};
  for (int v = 0; v < n; ++v) {
    const double x = sheet.vertices(v, 0);
    places.row(v) = (motion(x) * sheet.vertices.row(v).transpose()).transpose();
    known[v] = std::abs(x - 1) > 0.4;
    if (!known[v] && x < 0.8) anchor[0] = v;
    if (!known[v] && x > 1.2) anchor[1] = v;
  }
  Points extra(2, 3);
  extra << 1.5, 0.1, 1, 0.5, 0.1, 1;  // each near the half that the other one goes with
  const Points moved = followMatches(sheet, known, places, extra, {anchor[0], anchor[1]});
  int checked = 0;
  for (int v = 0; v < n; ++v)
    if (!known[v] && std::abs(sheet.vertices(v, 0) - 1) > 0.1) {
      EXPECT_LT((moved.row(v) - places.row(v)).norm(), 1e-9) << v;
      ++checked;
    }
  EXPECT_GT(checked, 100);
  for (int i : {0, 1})
    EXPECT_LT((moved.row(n + i).transpose() - motion(2 * i) * extra.row(i).transpose()).norm(),
              1e-9);
}

TEST(FollowMatches, leavesTheShapeWhereNothingIsKnown) {
  const TriangleMesh sphere = test::sphere(1);
  const std::vector<char> none(sphere.vertices.rows(), 0);
  const Points places = Points::Zero(sphere.vertices.rows(), 3);
  EXPECT_EQ(followMatches(sphere, none, places, Points(0, 3), {}), sphere.vertices);
}

}  // namespace
}  // namespace posture
