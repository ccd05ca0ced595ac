// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/synthesis/ray_caster.h>
#include <posture/synthesis/simulated_scan.h>

#include <gtest/gtest.h>

#include "body_checks.h"
#include "support/bodies.h"
#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <tuple>
#include <vector>

namespace posture {
namespace {

using namespace test;

/// Made once: that takes longer than to scan it.
const ArticulatedBody& bodyOf(BodyKind kind,
                              int pose = 0,
                              int tessellation = 0,
                              int vertices = 2500) {
  static std::map<std::tuple<BodyKind, int, int, int>, ArticulatedBody> bodies;
  const auto key = std::make_tuple(kind, pose, tessellation, vertices);
  const auto known = bodies.find(key);
  if (known != bodies.end()) return known->second;
  return bodies[key] = makeBody(bodyOptions(kind, pose, tessellation, vertices));
}

ScanOptions scanOptions(int views, double noise, std::uint64_t seed = 3) {
  ScanOptions options;
  options.views = views;
  options.points = 3000;
  options.noise = noise;
  options.seed = seed;
  return options;
}

/// Each point that shows a place of the body: how far it is from the surface's vertex nearest to
/// that place, in body units.
std::vector<double> distancesFromPlace(const SimulatedScan& scan) {
  std::vector<double> distances;
  for (std::size_t i = 0; i < scan.vertex.size(); ++i)
    if (scan.vertex[i] >= 0)
      distances.push_back((scan.cloud.points.row(static_cast<Eigen::Index>(i)) -
                           scan.surface.vertices.row(scan.vertex[i]))
                              .norm() /
                          scan.unit);
  std::sort(distances.begin(), distances.end());
  return distances;
}

TEST(SimulatedScan, hasAboutAsManyPointsAsAsked) {
  for (const BodyKind kind : {BodyKind::HUMAN, BodyKind::QUADRUPED})
    for (const int views : {1, 6}) {
      const SimulatedScan scan =
          scanBody(bodyOf(kind, kind == BodyKind::HUMAN ? 6 : 2), scanOptions(views, 1));
      const auto returns = scan.cloud.points.col(0).array().isFinite().count();
      EXPECT_NEAR(static_cast<double>(returns) / 3000, 1, 0.15);
      ASSERT_EQ(scan.rest_position.rows(), scan.cloud.points.rows());
      ASSERT_EQ(static_cast<Eigen::Index>(scan.vertex.size()), scan.cloud.points.rows());
    }
}

TEST(SimulatedScan, ofOneViewIsAGridInTheCamerasFrame) {
  const SimulatedScan scan = scanBody(bodyOf(BodyKind::HUMAN), scanOptions(1, 1));
  ASSERT_GT(scan.cloud.width, 0);
  EXPECT_EQ(scan.cloud.points.rows() % scan.cloud.width, 0);
  EXPECT_EQ(scan.cloud.sensor, Eigen::Vector3d(0, 0, 0));
  // x / z goes with the column, y / z with the row.
  const double middle = 0.5 * scan.cloud.width;
  double focal = 0;
  for (Eigen::Index i = 0; i < scan.cloud.points.rows(); ++i) {
    const Eigen::RowVector3d p = scan.cloud.points.row(i);
    if (!p.allFinite()) continue;
    const double column = static_cast<double>(i % scan.cloud.width) + 0.5 - middle;
    const double row = static_cast<double>(i / scan.cloud.width) + 0.5 - middle;
    if (focal == 0) focal = column * p.z() / p.x();
    ASSERT_GT(p.z(), 0);
    ASSERT_NEAR(p.x() / p.z() * focal, column, 1e-6);
    ASSERT_NEAR(p.y() / p.z() * focal, row, 1e-6);
  }
}

TEST(SimulatedScan, ofSeveralViewsIsNoGrid) {
  const SimulatedScan scan = scanBody(bodyOf(BodyKind::QUADRUPED, 2), scanOptions(3, 1));
  EXPECT_EQ(scan.cloud.width, 0);
  EXPECT_FALSE(scan.cloud.sensor);
  EXPECT_TRUE(scan.cloud.points.allFinite());
}

TEST(SimulatedScan, withoutNoiseLiesOnTheSurface) {
  for (const int views : {1, 4}) {
    const ArticulatedBody& body = bodyOf(BodyKind::HUMAN, 6);
    const SimulatedScan scan = scanBody(body, scanOptions(views, 0));
    const double edge = meanEdgeOf(body.mesh);
    const std::vector<double> distances = distancesFromPlace(scan);
    ASSERT_GT(distances.size(), 2500u);
    EXPECT_LT(distances.back(), 2 * edge);
    // The rest place and the point are the same place of one face: barycentric coordinates agree.
    const RayCaster caster(scan.surface);
    for (Eigen::Index i = 0; i < scan.cloud.points.rows(); i += 7) {
      const Eigen::Vector3d p = scan.cloud.points.row(i);
      if (!p.allFinite()) continue;
      const Eigen::Vector3d aim = Eigen::Vector3d(1, 2, 3).normalized() * scan.unit;
      double gap = caster.cast(p - 1e-6 * aim, aim).distance;
      gap = std::min(gap, caster.cast(p + 1e-6 * aim, -aim).distance);
      ASSERT_LT(gap, 1e-5) << i;
    }
  }
}

TEST(SimulatedScan, noisePutsItAboutAThousandthBesideTheSurface) {
  const ArticulatedBody& body = bodyOf(BodyKind::HUMAN, 0, 0, 20000);
  const double edge = meanEdgeOf(body.mesh);
  const auto beside = [&](double noise) {
    const SimulatedScan scan = scanBody(body, scanOptions(6, noise));
    // Across the surface: along its normal at the vertex.
    std::vector<double> gaps;
    Points normals = Points::Zero(scan.surface.vertices.rows(), 3);
    for (Eigen::Index f = 0; f < scan.surface.faces.rows(); ++f) {
      const Eigen::RowVector3d a = scan.surface.vertices.row(scan.surface.faces(f, 0)),
                               b = scan.surface.vertices.row(scan.surface.faces(f, 1)),
                               c = scan.surface.vertices.row(scan.surface.faces(f, 2));
      for (int i = 0; i < 3; ++i) normals.row(scan.surface.faces(f, i)) += (b - a).cross(c - a);
    }
    for (std::size_t i = 0; i < scan.vertex.size(); ++i) {
      if (scan.vertex[i] < 0) continue;
      const Eigen::RowVector3d offset = scan.cloud.points.row(static_cast<Eigen::Index>(i)) -
                                        scan.surface.vertices.row(scan.vertex[i]);
      gaps.push_back(std::abs(offset.dot(normals.row(scan.vertex[i]).normalized())) / scan.unit);
    }
    std::nth_element(gaps.begin(), gaps.begin() + static_cast<long>(gaps.size() / 2), gaps.end());
    return gaps[gaps.size() / 2];
  };
  EXPECT_LT(edge, 0.01);
  EXPECT_LT(beside(0), 0.0003);
  EXPECT_GT(beside(1), 0.0004);
  EXPECT_LT(beside(1), 0.0015);
  EXPECT_NEAR(beside(8) / beside(4), 2, 0.3);
}

// From the camera's place nothing is in front of what it sees.
TEST(SimulatedScan, seesNothingThroughTheBody) {
  const SimulatedScan scan = scanBody(bodyOf(BodyKind::QUADRUPED, 2), scanOptions(1, 0));
  const RayCaster caster(scan.surface);
  int seen = 0;
  for (Eigen::Index i = 0; i < scan.cloud.points.rows(); ++i) {
    const Eigen::Vector3d p = scan.cloud.points.row(i);
    if (!p.allFinite()) continue;
    ++seen;
    ASSERT_NEAR(caster.cast(Eigen::Vector3d::Zero(), p).distance, 1, 1e-9);
  }
  EXPECT_GT(seen, 2500);
}

TEST(SimulatedScan, surfaceIsTheBodyMovedAndScaled) {
  const ArticulatedBody& body = bodyOf(BodyKind::HUMAN);
  const SimulatedScan scan = scanBody(body, scanOptions(5, 1)),
                      other = scanBody(body, scanOptions(5, 1, 4));
  EXPECT_EQ(scan.surface.faces, body.mesh.faces);
  EXPECT_NEAR(volumeOf(scan.surface) / std::pow(scan.unit, 3) / volumeOf(body.mesh), 1, 1e-9);
  EXPECT_GT((scan.surface.vertices.row(0) / scan.unit - other.surface.vertices.row(0) / other.unit)
                .norm(),
            0.1);
}

TEST(SimulatedScan, truthJoinsEqualPlaces) {
  const SimulatedScan source = scanBody(bodyOf(BodyKind::HUMAN, 0), scanOptions(6, 1));
  const SimulatedScan target = scanBody(bodyOf(BodyKind::HUMAN, 6, 1), scanOptions(6, 1, 9));
  const std::vector<VertexPair> truth = groundTruth(source, target);
  EXPECT_GT(truth.size(), 2500u);
  EXPECT_LT(truth.size(), source.vertex.size());
  std::vector<int> counterpart(source.vertex.size(), -1);
  for (const VertexPair& pair : truth)
    counterpart[static_cast<std::size_t>(pair.source)] = pair.target;
  for (std::size_t i = 0; i < source.vertex.size(); ++i) {
    int nearest = -1;
    double gap = 1.5 * target.spacing;
    for (Eigen::Index j = 0; j < target.rest_position.rows(); ++j) {
      const double d =
          (target.rest_position.row(j) - source.rest_position.row(static_cast<Eigen::Index>(i)))
              .norm();
      if (d < gap) gap = d, nearest = static_cast<int>(j);
    }
    ASSERT_EQ(counterpart[i], nearest) << i;
    ASSERT_TRUE(nearest < 0 || source.vertex[i] >= 0);
  }
  for (const VertexPair& pair : mirrorTruth(source, target)) {
    const double x = source.rest_position(pair.source, 0), y = target.rest_position(pair.target, 0);
    if (std::abs(x) > 0.05) {
      ASSERT_LT(x * y, 0);
    }
  }
}

TEST(SimulatedScan, oneViewLeavesOutWhatItHasNotSeen) {
  const SimulatedScan all = scanBody(bodyOf(BodyKind::HUMAN, 0), scanOptions(6, 1));
  const SimulatedScan front = scanBody(bodyOf(BodyKind::HUMAN, 6), scanOptions(1, 1));
  const auto share =
      static_cast<double>(groundTruth(all, front).size()) / static_cast<double>(all.vertex.size());
  EXPECT_GT(share, 0.25);
  EXPECT_LT(share, 0.65);
}

TEST(SimulatedScan, refusesWhatCannotBe) {
  const ArticulatedBody& body = bodyOf(BodyKind::HUMAN);
  EXPECT_THROW(scanBody(body, scanOptions(0, 1)), std::invalid_argument);
  EXPECT_THROW(scanBody(body, scanOptions(1, -1)), std::invalid_argument);
  EXPECT_THROW(scanBody(ArticulatedBody(), scanOptions(1, 1)), std::invalid_argument);
  ScanOptions few = scanOptions(1, 1);
  few.points = 10;
  EXPECT_THROW(scanBody(body, few), std::invalid_argument);
}

}  // namespace
}  // namespace posture
