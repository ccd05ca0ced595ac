// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cloud_message.h"
#include "result_messages.h"
#include <cmath>
#include <set>
#include <support/shapes.h>

namespace posture::app {
namespace {

using diagnostic_msgs::DiagnosticStatus;
using visualization_msgs::Marker;

const Eigen::Matrix3d TURN =
    Eigen::AngleAxisd(1.2, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();

/// A sheet of points with normals, in two parts, and the same turned and twice as large. Each point
/// has its own number as counterpart, but the first, which has none.
struct TurnedSheet {
  TurnedSheet() {
    const TriangleMesh sheet = test::grid(70, 60, 7, 6);
    const int n = static_cast<int>(sheet.vertices.rows());
    source.cloud.points = sheet.vertices;
    source.cloud.normals = Eigen::RowVector3d(0, 0, 3).replicate(n, 1);
    target.cloud.points = 2 * sheet.vertices * TURN.transpose();
    source_message = messageOf(source.cloud, header("left"));
    target_message = messageOf(target.cloud, header("right"));

    result.status = Status::REGISTERED;
    result.message = "as it should be";
    result.scale = 2;
    result.trust = 0.75;
    result.alternatives.resize(1);
    result.deformed = result.surface_deformed = target.cloud.points;
    result.source.area = 42;
    result.target.area = 168;
    result.source.mean_edge_length = 0.1;
    result.source_scan.emplace();
    result.source_scan->mesh = sheet;
    result.target_scan.emplace();
    result.target_scan->mesh = {target.cloud.points, sheet.faces};
    result.correspondence.confidence = Vector::Constant(n, 0.5);
    for (int i = 0; i < n; ++i) {
      SurfacePoint place;
      place.vertex = i > 0 ? i : -1;
      result.correspondence.on_target.push_back(place);
      place.vertex = i;
      result.target_scan->on_mesh.push_back(place);
      segments.label.push_back(i == 0 ? -1 : sheet.vertices(i, 0) > 3 ? 1 : 0);
    }
    segments.surface.mesh = sheet;
    segments.parts.count = 2;
    segments.parts.label = segments.label;
  }

  static std_msgs::Header header(const std::string& frame) {
    std_msgs::Header header;
    header.frame_id = frame;
    return header;
  }

  SideView sourceView() const { return {source_message, source}; }
  SideView targetView() const { return {target_message, target}; }

  Shape source, target;
  sensor_msgs::PointCloud2 source_message, target_message;
  RegistrationResult result;
  ShapeSegments segments;
};

TEST(RegisteredCloud, normalsTurnWithTheSurfaceAndKeepTheirLength) {
  const TurnedSheet sheet;
  const sensor_msgs::PointCloud2 message =
      registeredCloud(sheet.sourceView(), sheet.targetView(), sheet.result);
  EXPECT_EQ(message.header.frame_id, "right");
  const PointCloud cloud = cloudOf(message);
  EXPECT_LT((cloud.points - sheet.target.cloud.points).cwiseAbs().maxCoeff(), 1e-5);
  const Eigen::RowVector3d turned = 3 * TURN.col(2).transpose();
  EXPECT_LT((cloud.normals.rowwise() - turned).cwiseAbs().maxCoeff(), 1e-3);
}

TEST(RegisteredCloud, unknownNormalsStayUnknown) {
  TurnedSheet sheet;
  sheet.source.cloud.normals.row(7).setZero();
  sheet.source.cloud.normals.row(8).setConstant(NAN);
  const PointCloud cloud =
      cloudOf(registeredCloud(sheet.sourceView(), sheet.targetView(), sheet.result));
  EXPECT_TRUE(cloud.normals.row(7).isZero());
  EXPECT_TRUE(std::isnan(cloud.normals(8, 0)));
  EXPECT_TRUE(cloud.normals.row(9).allFinite());
}

TEST(CorrespondenceLines, areThinnedEvenlyAndJoinCounterparts) {
  const TurnedSheet sheet;
  const Marker lines = correspondenceLines(sheet.sourceView(), sheet.targetView(), sheet.result);
  EXPECT_EQ(lines.header.frame_id, "right");
  ASSERT_EQ(lines.points.size(), 2U * MOST_LINES);
  ASSERT_EQ(lines.colors.size(), lines.points.size());
  EXPECT_GT(lines.scale.x, 0);
  std::set<double> columns;
  for (std::size_t k = 0; k < lines.points.size(); k += 2) {
    const Eigen::Vector3d a(lines.points[k].x, lines.points[k].y, lines.points[k].z);
    const Eigen::Vector3d b(lines.points[k + 1].x, lines.points[k + 1].y, lines.points[k + 1].z);
    ASSERT_LT((2 * TURN * a - b).norm(), 1e-9);
    EXPECT_FALSE(a.isZero()) << "the first point has no counterpart";
    columns.insert(a.x());
  }
  EXPECT_GT(columns.size(), 60U) << "of 71 columns";
}

TEST(CorrespondenceLines, noneClearWhatWasShown) {
  TurnedSheet sheet;
  for (SurfacePoint& place : sheet.result.correspondence.on_target) place.vertex = -1;
  const Marker lines = correspondenceLines(sheet.sourceView(), sheet.targetView(), sheet.result);
  EXPECT_EQ(lines.action, Marker::DELETE);
  EXPECT_TRUE(lines.points.empty());
}

TEST(SegmentMarkers, eachPartIsOne) {
  const TurnedSheet sheet;
  const auto markers = segmentMarkers(sheet.sourceView(), sheet.result, &sheet.segments).markers;
  ASSERT_EQ(markers.size(), 3U);
  EXPECT_EQ(markers[0].action, Marker::DELETEALL);
  EXPECT_EQ(markers[1].points.size() + markers[2].points.size(), sheet.segments.label.size() - 1);
  for (const auto& point : markers[1].points) EXPECT_LE(point.x, 3);
  for (const auto& point : markers[2].points) EXPECT_GT(point.x, 3);
  EXPECT_FALSE(markers[1].color.r == markers[2].color.r &&
               markers[1].color.g == markers[2].color.g);
  EXPECT_FLOAT_EQ(markers[1].color.a, 1);
}

TEST(SegmentMarkers, noneClearWhatWasShown) {
  const TurnedSheet sheet;
  const auto markers = segmentMarkers(sheet.sourceView(), sheet.result, nullptr).markers;
  ASSERT_EQ(markers.size(), 1U);
  EXPECT_EQ(markers[0].action, Marker::DELETEALL);
}

TEST(Outcome, saysHowFarToTrustIt) {
  TurnedSheet sheet;
  const auto value = [](const DiagnosticStatus& status, const std::string& key) {
    for (const auto& entry : status.values)
      if (entry.key == key) return entry.value;
    return std::string("none");
  };
  const DiagnosticStatus ok = outcome(sheet.result, &sheet.segments, 1.25);
  EXPECT_EQ(int{ok.level}, int{DiagnosticStatus::OK});
  EXPECT_EQ(ok.message, "as it should be");
  EXPECT_EQ(value(ok, "trust"), "0.750");
  EXPECT_EQ(value(ok, "share mapped"), "1.000");
  EXPECT_EQ(value(ok, "parts"), "2");
  sheet.result.status = Status::UNDECIDED;
  const DiagnosticStatus warn = outcome(sheet.result, nullptr, 1.25);
  EXPECT_EQ(int{warn.level}, int{DiagnosticStatus::WARN});
  EXPECT_EQ(value(warn, "parts"), "none");
  EXPECT_EQ(int{failure("no").level}, int{DiagnosticStatus::ERROR});
}

}  // namespace
}  // namespace posture::app
