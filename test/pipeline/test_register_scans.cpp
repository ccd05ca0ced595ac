// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/error.h>
#include <posture/io/correspondence_io.h>
#include <posture/io/mesh_io.h>
#include <posture/io/shape_io.h>
#include <posture/mesh/areas.h>
#include <posture/pipeline/register_shapes.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/files.h"
#include <cmath>
#include <filesystem>
#include <limits>

namespace posture {
namespace {

using testing::StartsWith;

const std::filesystem::path SCANS = std::filesystem::path(DATA_DIR) / "scans";

constexpr int FAR_OFF = 7000;

/// The bundled pair of raw scans, registered once.
struct Registered {
  Shape source = readShape(SCANS / "human-pose0-scan.pcd");
  Shape target = readShape(SCANS / "human-pose6-scan.pcd");
  RegistrationResult result;
  double progress = 0;  // at the end
  Registered() {
    // As an organised cloud has them: points that were not seen.
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (int i : {0, 100, 5000}) source.cloud.points.row(i).setConstant(nan);
    // As a broken file has it.
    source.cloud.points.row(FAR_OFF) << 1e300, -1e30, 0;
    result = registerShapes(
        source, target, {}, [this](const StageEvent& event) { progress = event.progress; });
  }
};

const Registered& registered() {
  static const Registered once;
  return once;
}

/// Mean distance, over the square root of the clean target's area, between where points are mapped
/// and a known counterpart.
double meanMiss(const std::string& truth) {
  const Registered& r = registered();
  const double size = rootArea(readMesh(SCANS / "human-pose6.ply").mesh);
  double sum = 0;
  int count = 0;
  for (const VertexPair& pair : readVertexPairs(SCANS / truth)) {
    const int found = r.result.correspondence.on_target[pair.source].vertex;
    if (found < 0) continue;
    sum += (r.target.cloud.points.row(found) - r.target.cloud.points.row(pair.target)).norm();
    ++count;
  }
  return sum / count / size;
}

TEST(RegisterScans, aPairOfRawScansGoesToTheRightPlaces) {
  EXPECT_EQ(registered().result.status, Status::REGISTERED) << registered().result.message;
  const double miss = meanMiss("human-pose0-pose6-scan.txt");
  EXPECT_LT(miss, 0.03);
  EXPECT_GT(meanMiss("human-pose0-pose6-scan-mirror.txt"), 5 * miss);
}

TEST(RegisterScans, aPointFarOffHasNoPlace) {
  const RegistrationResult& result = registered().result;
  EXPECT_LT(result.source_scan->on_mesh[FAR_OFF].vertex, 0);
  EXPECT_LT(result.correspondence.on_target[FAR_OFF].vertex, 0);
}

TEST(RegisterScans, progressComesNearOneAndStaysBelow) {
  EXPECT_GT(registered().progress, 0.8);
  EXPECT_LE(registered().progress, 1);
}

TEST(RegisterScans, everyPointHasARow) {
  const auto& [source, target, result, progress] = registered();
  const auto n = source.cloud.points.rows();
  ASSERT_EQ(result.correspondence.on_target.size(), n);
  ASSERT_EQ(result.correspondence.confidence.size(), n);
  ASSERT_EQ(result.deformed.rows(), n);
  ASSERT_TRUE(result.source_scan && result.target_scan);
  ASSERT_EQ(result.source_scan->on_mesh.size(), n);
  EXPECT_EQ(result.surface_deformed.rows(), result.source_scan->mesh.vertices.rows());
  int mapped = 0;
  for (int i = 0; i < n; ++i) {
    const SurfacePoint& place = result.correspondence.on_target[i];
    const bool seen = source.cloud.points.row(i).allFinite();
    EXPECT_EQ(result.deformed.row(i).allFinite(), seen);
    EXPECT_EQ(place.vertex < 0, result.correspondence.confidence[i] == 0);
    EXPECT_TRUE(result.source_scan->on_mesh[i].vertex >= 0 || place.vertex < 0);
    if (place.vertex < 0) continue;
    ++mapped;
    ASSERT_TRUE(seen);
    ASSERT_LT(place.vertex, target.cloud.points.rows());
    // An outlier is no counterpart.
    EXPECT_GE(result.target_scan->on_mesh[place.vertex].vertex, 0);
    if (place.face < 0) continue;
    const TriangleMesh& surface = result.target_scan->mesh;
    ASSERT_LT(place.face, surface.faces.rows());
    EXPECT_NEAR(place.barycentric.sum(), 1, 1e-9);
    Eigen::RowVector3d at = Eigen::RowVector3d::Zero();
    for (int k = 0; k < 3; ++k)
      at += place.barycentric[k] * surface.vertices.row(surface.faces(place.face, k));
    EXPECT_LT((at - target.cloud.points.row(place.vertex)).norm(),
              6 * result.target_scan->summary.mesh_spacing);
  }
  EXPECT_GT(mapped, 0.9 * static_cast<double>(n));
}

TEST(RegisterScans, namesTheSideThatCannotBeUsed) {
  Shape line;
  line.cloud.points = Points::Zero(100, 3);
  for (int i = 0; i < 100; ++i) line.cloud.points(i, 0) = i;
  const Shape& good = registered().target;
  EXPECT_THAT(test::inputErrorOf([&] { registerShapes(line, good); }), StartsWith("source "));
  EXPECT_THAT(test::inputErrorOf([&] { registerShapes(good, line); }), StartsWith("target "));
}

}  // namespace
}  // namespace posture
