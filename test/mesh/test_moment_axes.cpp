// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/mesh/moment_axes.h>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace posture {
namespace {

/// A body that reaches 1, 2 and 4 along x, y and z, and half as far back.
Points unevenCross() {
  Points points(9, 3);
  points << 1, 0, 0, -0.5, 0, 0, -0.5, 0, 0,  //
      0, 2, 0, 0, -1, 0, 0, -1, 0,            //
      0, 0, 4, 0, 0, -2, 0, 0, -2;
  return points;
}

TEST(MomentAxes, followTheSecondMomentsAndPointToTheFarSide) {
  EXPECT_TRUE(momentAxes(unevenCross(), Vector::Ones(9)).isApprox(Eigen::Matrix3d::Identity()));
}

TEST(MomentAxes, turnWithThePoints) {
  for (int i = 0; i < 20; ++i) {
    const Eigen::Matrix3d turn =
        Eigen::AngleAxisd(0.5 * i, Eigen::Vector3d(1, i - 9, 2).normalized()).toRotationMatrix();
    const Eigen::Matrix3d axes = momentAxes(unevenCross() * turn.transpose(), Vector::Ones(9));
    EXPECT_TRUE(axes.isApprox(turn, 1e-12)) << i;
  }
}

TEST(MomentAxes, areARotationOfAMirroredBodyToo) {
  Points mirrored = unevenCross();
  mirrored.col(0) *= -1;
  const Eigen::Matrix3d axes = momentAxes(mirrored, Vector::Ones(9));
  EXPECT_TRUE((axes.transpose() * axes).isApprox(Eigen::Matrix3d::Identity()));
  EXPECT_NEAR(axes.determinant(), 1, 1e-12);
}

TEST(MomentAxes, leaveOutWhatHasNoWeight) {
  Points points(10, 3);
  points << unevenCross(), 50, -80, 10;
  Vector weights = Vector::Ones(10);
  weights[9] = 0;
  EXPECT_TRUE(momentAxes(points, weights).isApprox(Eigen::Matrix3d::Identity()));
}

}  // namespace
}  // namespace posture
