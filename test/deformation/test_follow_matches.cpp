// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/deformation/follow_matches.h>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "support/shapes.h"

namespace posture {
namespace {

TEST(FollowMatches, carriesARigidMotionToEverything) {
  const TriangleMesh sphere = test::sphere(3);
  const int n = static_cast<int>(sphere.vertices.rows());
  const Eigen::Isometry3d motion = Eigen::Translation3d(1, -2, 3) *
                                   Eigen::AngleAxisd(0.8, Eigen::Vector3d(1, 1, 0).normalized());
  const auto moved = [&](const Points& p) -> Points {
    return (motion * p.transpose()).transpose();
  };
  std::vector<char> known(n, 0);
  for (int v = 0; v < n; v += 3) known[v] = 1;
  Points extra(3, 3);
  extra << 0.1, 0.2, 0.3, -1, 0.5, 2, 0, 0, 0;
  const Points result = followMatches(sphere, known, moved(sphere.vertices), extra, {5, 5, 8});
  EXPECT_LT((result.topRows(n) - moved(sphere.vertices)).norm(), 1e-9);
  EXPECT_LT((result.bottomRows(3) - moved(extra)).norm(), 1e-9);
}

TEST(FollowMatches, leavesTheShapeWhereNothingIsKnown) {
  const TriangleMesh sphere = test::sphere(1);
  const std::vector<char> none(sphere.vertices.rows(), 0);
  const Points places = Points::Zero(sphere.vertices.rows(), 3);
  EXPECT_EQ(followMatches(sphere, none, places, Points(0, 3), {}), sphere.vertices);
}

}  // namespace
}  // namespace posture
