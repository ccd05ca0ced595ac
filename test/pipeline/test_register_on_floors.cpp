// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/mesh/areas.h>
#include <posture/mesh/edges.h>
#include <posture/pipeline/register_shapes.h>
#include <posture/pipeline/segment_shape.h>

#include <gtest/gtest.h>

#include "pipeline/on_floor.h"
#include "support/bodies.h"
#include <string>

namespace posture {
namespace {

using test::onFloor;

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

}  // namespace
}  // namespace posture
