// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/io/mesh_io.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cloud_message.h"
#include "node_outputs.h"

// The node runs beside this program, see register_files.test, and may have ended its work before.
namespace posture::test {
namespace {

using diagnostic_msgs::DiagnosticStatus;
using sensor_msgs::PointCloud2;

TEST(RegisterFiles, publishesForThoseWhoComeLate) {
  const std::string shapes = DATA_DIR "/quadruped/quadruped-pose";
  const Points target = readMesh(shapes + "1.ply").mesh.vertices;
  const Eigen::Index source_count = readMesh(shapes + "0.ply").mesh.vertices.rows();

  const NodeOutputs outputs;
  ASSERT_TRUE(outputs.waitForStatus(1));
  ASSERT_TRUE(outputs.waitForResult(1));
  const DiagnosticStatus& status = outputs.diagnostics.at(0).status.at(0);
  EXPECT_EQ(int{status.level}, int{DiagnosticStatus::OK}) << status.message;
  EXPECT_LT(valueOf(status, "mean miss there and back"), 0.02);

  const PointCloud2& registered = outputs.registered.at(0);
  EXPECT_EQ(registered.header.frame_id, "stage");
  EXPECT_THAT(fieldNames(registered), testing::ElementsAre("x", "y", "z"));
  const Points moved = app::cloudOf(registered).points;
  ASSERT_EQ(moved.rows(), source_count);
  const double error = meanError(moved, target, shapes + "0-pose1.txt");
  EXPECT_LT(error, 0.015);
  EXPECT_LT(5 * error, meanError(moved, target, shapes + "0-pose1-mirror.txt"));

  EXPECT_THAT(fieldNames(outputs.target_colored.at(0)),
              testing::ElementsAre("x", "y", "z", "rgb", "source", "confidence"));
  EXPECT_GT(outputs.correspondences.at(0).points.size(), 2000U);
  EXPECT_GT(outputs.segments.at(0).markers.size(), 3U);
}

}  // namespace
}  // namespace posture::test

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "test_register_files");
  return RUN_ALL_TESTS();
}
