// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "pipeline/on_floor.h"
#include "sides/leave_out_background.h"
#include "support/bodies.h"
#include "support/shapes.h"

namespace posture {
namespace {

TEST(LeaveOutBackground, aPlaceOfTheBodyIsTheBodysWhicheverVertexIsTheFirstThere) {
  // A spindle that stands on a vertex of a floor; the floor's vertices come first.
  const TriangleMesh floor = test::grid(30, 30, 2, 2);
  const double side = floor.vertices(1, 0) - floor.vertices(0, 0);
  TriangleMesh spindle = test::sphere(1);
  spindle.vertices *= Eigen::Vector3d(0.2, 0.2, 0.8).asDiagonal();
  const int foot = [&] {
    Eigen::Index lowest = 0;
    spindle.vertices.col(2).minCoeff(&lowest);
    return static_cast<int>(lowest);
  }();
  const Eigen::RowVector3d shift =
      Eigen::RowVector3d(15 * side, 15 * side, 0) - spindle.vertices.row(foot);
  spindle.vertices.rowwise() += shift;
  TriangleMesh mesh = test::joined(floor, spindle);
  const int n = static_cast<int>(floor.vertices.rows());
  int at_foot = -1;
  for (int v = 0; v < n; ++v)
    if ((floor.vertices.row(v) - spindle.vertices.row(foot)).norm() < 1e-9) at_foot = v;
  ASSERT_GE(at_foot, 0);
  mesh.vertices.row(n + foot) = mesh.vertices.row(at_foot);
  const Background background = leaveOutBackground(mesh);
  ASSERT_GT(background.faces, 1000);
  EXPECT_EQ(background.vertices[n + foot], 0);
  EXPECT_EQ(background.vertices[at_foot], 0);
  EXPECT_EQ(background.vertices[at_foot + 1], 1);
  EXPECT_EQ(background.left_over, 1);
}

TEST(LeaveOutBackground, leavesTheOtherFacesTheirNumbersAndCorners) {
  const TriangleMesh body = test::body(0, 1200).mesh, given = test::onFloor(body, 2);
  TriangleMesh mesh = given;
  const Background background = leaveOutBackground(mesh);
  ASSERT_EQ(mesh.faces.rows(), given.faces.rows());
  int left = 0;
  for (int f = 0; f < mesh.faces.rows(); ++f) {
    const auto corners = mesh.faces.row(f);
    if (corners == given.faces.row(f)) continue;
    ++left;
    EXPECT_TRUE(corners[0] == corners[1] && corners[1] == corners[2]);
    EXPECT_TRUE((given.faces.row(f).array() == corners[0]).any());
  }
  EXPECT_EQ(left, background.faces);
  EXPECT_GE(left, 1800);
  TriangleMesh alone = body;
  EXPECT_EQ(leaveOutBackground(alone).faces, 0);
  EXPECT_EQ(alone.faces, body.faces);
}

}  // namespace
}  // namespace posture
