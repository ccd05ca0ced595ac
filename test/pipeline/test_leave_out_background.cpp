// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/mesh/areas.h>
#include <posture/mesh/edges.h>
#include <posture/pipeline/register_shapes.h>
#include <posture/pipeline/segment_shape.h>

#include <gtest/gtest.h>

#include "outcome/drop_background.h"
#include "sides/leave_out_background.h"
#include "support/bodies.h"
#include "support/shapes.h"
#include <algorithm>
#include <cmath>
#include <vector>

namespace posture {
namespace {

/// A body on a floor of 30 x 30 quads, of which every vertex comes after the body's.
TriangleMesh onFloor(const TriangleMesh& body, double size) {
  TriangleMesh floor = test::grid(30, 30, size, size);
  floor.vertices.leftCols(2).array() -= 0.5 * size;
  floor.vertices.col(2).setConstant(body.vertices.col(2).minCoeff());
  return test::joined(body, floor);
}

/// Two poses of a quadruped, each on a floor of its own.
class OnFloors : public testing::Test {
 protected:
  static const ArticulatedBody source_, target_;
  static const TriangleMesh source_mesh_, target_mesh_;

  static int sourceBody() { return static_cast<int>(source_.mesh.vertices.rows()); }
  static int targetBody() { return static_cast<int>(target_.mesh.vertices.rows()); }

  static const RegistrationResult& result() {
    static const RegistrationResult once = [] {
      RegistrationOptions options;
      options.both_ways = true;
      return registerShapes(source_mesh_, target_mesh_, options);
    }();
    return once;
  }
};

const ArticulatedBody OnFloors::source_ = test::body(0, 1200);
const ArticulatedBody OnFloors::target_ = test::body(2, 1200, 1);
const TriangleMesh OnFloors::source_mesh_ = onFloor(source_.mesh, 2);
const TriangleMesh OnFloors::target_mesh_ = onFloor(target_.mesh, 3);

TEST_F(OnFloors, theBodyIsRegistered) {
  EXPECT_EQ(result().status, Status::REGISTERED) << result().message;
  EXPECT_NE(result().message.find("a floor or wall in the source and target is left out"),
            std::string::npos)
      << result().message;
  EXPECT_GE(result().source.background_faces, 1800);
  EXPECT_EQ(result().source.cleaning.degenerate_faces, 0);
  EXPECT_EQ(result().source.cleaning.unreferenced_vertices, 0);
  EXPECT_EQ(result().source.cleaning.loose_vertices, 0);
  EXPECT_LT(result().source.area, 1.1 * surfaceArea(source_.mesh));
  double sum = 0;
  int count = 0;
  for (const VertexPair& pair : groundTruth(source_, target_)) {
    const int found = result().correspondence.on_target[pair.source].vertex;
    if (found < 0) continue;
    ASSERT_LT(found, targetBody());
    sum += (target_mesh_.vertices.row(found) - target_mesh_.vertices.row(pair.target)).norm();
    ++count;
  }
  EXPECT_GT(count, 0.9 * sourceBody());
  EXPECT_LT(sum / count, meanEdgeLength(target_.mesh));
}

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

TEST_F(OnFloors, floorsHaveNoCounterpartAndNoPart) {
  const Correspondence &there = result().correspondence, &back = result().back->correspondence;
  for (int v = sourceBody(); v < source_mesh_.vertices.rows(); ++v) {
    EXPECT_EQ(there.on_target[v].vertex, -1);
    EXPECT_EQ(there.confidence[v], 0);
  }
  for (int v = targetBody(); v < target_mesh_.vertices.rows(); ++v)
    EXPECT_EQ(back.on_target[v].vertex, -1);
  const ShapeSegments segments =
      segmentShape({{source_mesh_.vertices, {}, {}, 0, {}}, source_mesh_.faces}, {result()});
  ASSERT_EQ(segments.label.size(), static_cast<std::size_t>(source_mesh_.vertices.rows()));
  for (int v = 0; v < source_mesh_.vertices.rows(); ++v)
    EXPECT_TRUE(v < sourceBody() || segments.label[v] == -1) << v;
}

TEST_F(OnFloors, theFloorIsMovedAsAWhole) {
  const int n = sourceBody();
  for (int v = n; v + 1 < source_mesh_.vertices.rows(); ++v) {
    const double before = (source_mesh_.vertices.row(v) - source_mesh_.vertices.row(n)).norm();
    const double after = (result().deformed.row(v) - result().deformed.row(n)).norm();
    ASSERT_NEAR(after, result().scale * before, 1e-9);
  }
}

TEST(DropBackground, whatWasPutOntoAFloorHasNoCounterpart) {
  RegistrationResult result;
  result.correspondence.on_target.resize(3);
  for (int v = 0; v < 3; ++v) result.correspondence.on_target[v].vertex = std::min(v, 1);
  result.correspondence.confidence = Vector::Ones(3);
  result.back = WayBack{result.correspondence};
  const Background none, floor{1, {0, 1, 0}};
  dropBackground(none, Points::Zero(3, 3), floor, result);
  const auto places = [](const Correspondence& map) {
    std::vector<int> found;
    for (const SurfacePoint& place : map.on_target) found.push_back(place.vertex);
    return found;
  };
  EXPECT_EQ(places(result.correspondence), (std::vector<int>{0, -1, -1}));
  EXPECT_EQ(result.correspondence.confidence, Vector::Unit(3, 0));
  // There the floor is what has no row.
  EXPECT_EQ(places(result.back->correspondence), (std::vector<int>{0, -1, 1}));
}

TEST(LeaveOutBackground, leavesTheOtherFacesTheirNumbersAndCorners) {
  const TriangleMesh body = test::body(0, 1200).mesh, given = onFloor(body, 2);
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
