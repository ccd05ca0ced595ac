// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/mesh/position_of.h>

#include <Eigen/LU>
#include <gtest/gtest.h>

#include "outcome/refer_to_points.h"
#include "sides/side_surface.h"
#include "support/shapes.h"
#include <limits>
#include <utility>

namespace posture {
namespace {

constexpr double NONE = std::numeric_limits<double>::quiet_NaN();

/// A sheet of 3 x 3 vertices, one apart, through four points: two in its first face, an outlier
/// and a missing one.
struct Scan {
  Scan() {
    shape.cloud.points.resize(4, 3);
    shape.cloud.points << 0.9, 0.1, 0, 50, 50, 50, NONE, NONE, NONE, 1.7, 1.9, 0;
    surface.mesh = test::grid(2, 2, 2, 2);
    ScanSurface scan;
    scan.mesh = surface.mesh;
    scan.on_mesh.assign(4, {});
    scan.offset = Vector::Zero(4);
    scan.summary.missing = 1;
    for (int i : {0, 3}) scan.on_mesh[i] = placeOf(shape.cloud.points.row(i));
    surface.scan = std::move(scan);
  }

  /// The face of the sheet that a point is in.
  SurfacePoint placeOf(const Eigen::RowVector3d& point) const {
    const TriangleMesh& mesh = surface.mesh;
    for (int f = 0; f < mesh.faces.rows(); ++f) {
      Eigen::Matrix3d corners;
      for (int k = 0; k < 3; ++k) {
        corners.col(k) = mesh.vertices.row(mesh.faces(f, k)).transpose();
        corners(2, k) = 1;
      }
      const Eigen::Vector3d weights =
          corners.partialPivLu().solve(Eigen::Vector3d(point.x(), point.y(), 1));
      int nearest = 0;
      weights.maxCoeff(&nearest);
      if (weights.minCoeff() >= 0) return {mesh.faces(f, nearest), f, weights};
    }
    return {};
  }

  Shape shape;
  SideSurface surface;
};

/// The map of the sheet onto itself, with an answer's vertices.
RegistrationResult identity(const TriangleMesh& mesh) {
  RegistrationResult result;
  const auto n = static_cast<int>(mesh.vertices.rows());
  result.status = Status::REGISTERED;
  result.correspondence.confidence = Vector::LinSpaced(n, 0.1, 0.9);
  result.alternatives.resize(1);
  for (int v = 0; v < n; ++v) {
    result.correspondence.on_target.push_back({v, -1, Eigen::Vector3d::Zero()});
    result.alternatives[0].target_vertex.push_back(v);
  }
  result.deformed = mesh.vertices.rowwise() + Eigen::RowVector3d(0, 0, 5);
  return result;
}

TEST(ReferToPoints, aScannedSourceHasARowForEachPoint) {
  const Scan scan;
  RegistrationResult result = identity(scan.surface.mesh);
  const Correspondence vertices = result.correspondence;
  referToPoints(scan.shape, {}, scan.surface, SideSurface(scan.surface.mesh), result);
  const auto& on_target = result.correspondence.on_target;
  ASSERT_EQ(on_target.size(), 4U);
  const TriangleMesh& mesh = scan.surface.mesh;
  for (int i : {0, 3}) {
    const SurfacePoint& at = scan.surface.scan->on_mesh[i];
    EXPECT_LT((positionOf(mesh, on_target[i]) - scan.shape.cloud.points.row(i)).norm(), 1e-12);
    EXPECT_EQ(on_target[i].vertex, at.vertex);
    EXPECT_EQ(result.alternatives[0].target_vertex[i], at.vertex);
    double confidence = 0;
    for (int k = 0; k < 3; ++k)
      confidence += at.barycentric[k] * vertices.confidence[mesh.faces(at.face, k)];
    EXPECT_NEAR(result.correspondence.confidence[i], confidence, 1e-12);
    EXPECT_LT(
        (result.deformed.row(i) - scan.shape.cloud.points.row(i) - Eigen::RowVector3d(0, 0, 5))
            .norm(),
        1e-9);
  }
  EXPECT_EQ(on_target[1].vertex, -1);
  EXPECT_EQ(on_target[2].vertex, -1);
  EXPECT_EQ(result.correspondence.confidence[1], 0);
  EXPECT_EQ(result.alternatives[0].target_vertex[1], -1);
  EXPECT_TRUE(result.deformed.row(1).allFinite()) << "an outlier moves with what is near";
  EXPECT_TRUE(result.deformed.row(2).array().isNaN().all());
  EXPECT_EQ(result.surface_deformed.rows(), 9);
}

TEST(ReferToPoints, aPointWhoseFaceLeadsPartlyNowhereGoesWhereItsVertexGoes) {
  const Scan scan;
  const SurfacePoint& at = scan.surface.scan->on_mesh[0];
  for (const bool nearest : {true, false}) {
    RegistrationResult result = identity(scan.surface.mesh);
    for (int corner : scan.surface.mesh.faces.row(at.face))
      if ((corner == at.vertex) == nearest) result.correspondence.on_target[corner] = {};
    referToPoints(scan.shape, {}, scan.surface, SideSurface(scan.surface.mesh), result);
    EXPECT_EQ(result.correspondence.on_target[0].vertex, nearest ? -1 : at.vertex);
  }
}

TEST(ReferToPoints, verticesOfAScannedTargetAreItsNearestPoints) {
  const Scan scan;
  RegistrationResult result = identity(scan.surface.mesh);
  result.correspondence.on_target[4] = {};
  referToPoints({}, scan.shape, SideSurface(scan.surface.mesh), scan.surface, result);
  const TriangleMesh& mesh = scan.surface.mesh;
  ASSERT_EQ(result.correspondence.on_target.size(), 9U);
  for (int v = 0; v < 9; ++v) {
    if (v == 4) continue;
    const bool first = (mesh.vertices.row(v) - scan.shape.cloud.points.row(0)).norm() <
                       (mesh.vertices.row(v) - scan.shape.cloud.points.row(3)).norm();
    EXPECT_EQ(result.correspondence.on_target[v].vertex, first ? 0 : 3) << v;
    EXPECT_EQ(result.alternatives[0].target_vertex[v], first ? 0 : 3) << v;
  }
  EXPECT_EQ(result.correspondence.on_target[4].vertex, -1);
  EXPECT_EQ(result.deformed.rows(), 9);
  EXPECT_TRUE(result.target_scan.has_value());
}

}  // namespace
}  // namespace posture
