// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "support/shapes.h"
#include "working_frame.h"

namespace posture {
namespace {

TEST(WorkingFrame, aMotionInItIsOneOfTheGivenClouds) {
  const Points target = (30 * test::randomPoints(200, 1)).rowwise() + Eigen::RowVector3d(500, 0, 7);
  const WorkingFrame frame(target, 4);
  const Eigen::Isometry3d motion =
      Eigen::Translation3d(1, 2, -1) * Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 2) / 3);
  PointCloud cloud;
  cloud.points = 20 * test::randomPoints(50, 2);
  const Points local = frame.local(cloud).points, moved = (motion * local.transpose()).transpose();
  cloud.points = (frame.given(motion.matrix()) * cloud.points.transpose()).transpose();
  EXPECT_LT((frame.local(cloud).points - moved).cwiseAbs().maxCoeff(), 1e-9);
}

TEST(WorkingFrame, whatIsNearlyAMotionBecomesOneAndNoMirroring) {
  const WorkingFrame frame(test::randomPoints(200, 1), 1);
  for (const double last : {0.999, 1e-3, -1e-3, -1.0}) {
    Eigen::Matrix4d motion = Eigen::Matrix4d::Identity();
    motion(2, 2) = last;
    const Eigen::Matrix3d turn = frame.given(motion).linear();
    EXPECT_NEAR(turn.determinant(), 1, 1e-12) << last;
    EXPECT_LT((turn * turn.transpose() - Eigen::Matrix3d::Identity()).norm(), 1e-12) << last;
  }
}

TEST(WorkingFrame, pointsThrownFarOffAreInNoCloud) {
  PointCloud cloud;
  cloud.points = test::randomPoints(200, 1);
  const Points body = WorkingFrame(cloud.points, 1).local(cloud).points;
  cloud.points.conservativeResize(202, 3);
  cloud.points.row(200) << 200, 200, 200;
  cloud.points.row(201) << -1e9, 0, 0;
  const WorkingFrame frame(cloud.points, 1);
  EXPECT_EQ(frame.local(cloud).points, body);
  // Few points have one a side that does not count.
  PointCloud few;
  few.points = test::randomPoints(30, 2);
  few.points.row(7) << 0, 1e6, 0;
  EXPECT_EQ(WorkingFrame(few.points, 1).local(few).points.rows(), 29);
  // In another unit all points are far from the frame, and none from each other.
  cloud.points *= 1000;
  EXPECT_EQ(frame.local(cloud).points.rows(), 200);
}

}  // namespace
}  // namespace posture
