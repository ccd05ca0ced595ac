// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/mesh/rigid_motion.h>

#include <gtest/gtest.h>

namespace posture {
namespace {

Points takenBy(const Eigen::Isometry3d& motion, const Points& points) {
  return (points * motion.linear().transpose()).rowwise() + motion.translation().transpose();
}

Points corners() {
  Points points(5, 3);
  points << 0, 0, 0, 2, 0, 0, 0, 3, 0, 0, 0, 5, 1, 1, 2;
  return points;
}

TEST(RigidMotion, findsTheMotionThatWasMade) {
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
  motion.linear() = Eigen::AngleAxisd(2.1, Eigen::Vector3d(1, -2, 3).normalized()).matrix();
  motion.translation() << 7, -4, 0.5;
  EXPECT_TRUE(rigidMotion(corners(), takenBy(motion, corners())).isApprox(motion, 1e-12));
  const Points triangle = corners().topRows(3);
  EXPECT_TRUE(rigidMotion(triangle, takenBy(motion, triangle)).isApprox(motion, 1e-12));
}

TEST(RigidMotion, mirrorsNothing) {
  Points mirrored = corners();
  mirrored.col(2) *= -1;
  EXPECT_NEAR(rigidMotion(corners(), mirrored).linear().determinant(), 1, 1e-12);
}

TEST(RigidMotion, onlyMovesWhatTellsNoTurn) {
  const Points two = corners().topRows(2);
  const Points elsewhere = two.rowwise() + Eigen::RowVector3d(1, 2, 3);
  const Eigen::Isometry3d motion = rigidMotion(two, elsewhere);
  EXPECT_EQ(motion.linear(), Eigen::Matrix3d::Identity());
  EXPECT_EQ(motion.translation(), Eigen::Vector3d(1, 2, 3));
  EXPECT_TRUE(rigidMotion(Points(0, 3), Points(0, 3)).isApprox(Eigen::Isometry3d::Identity()));
}

}  // namespace
}  // namespace posture
