// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "noisy/smoothing.h"
#include "scan_shapes.h"

namespace posture {
namespace {

double meanRadius(const Points& points) { return points.rowwise().norm().mean(); }

double deviation(const Points& points) {
  return std::sqrt((points.rowwise().norm().array() - meanRadius(points)).square().mean());
}

TEST(Smoothing, takesNoiseOffASphereWithoutShrinkingIt) {
  OrientedPoints sphere{test::spherePoints(4000, 0.01), {}};
  sphere.normals = sphere.points.rowwise().normalized();
  const double before = deviation(sphere.points);
  const NeighborTable neighbors = NeighborSearch(sphere.points).table(32);
  smooth(neighbors, spacing(sphere.points, neighbors), 0.2, sphere);
  EXPECT_LT(deviation(sphere.points), before / 2);
  EXPECT_NEAR(meanRadius(sphere.points), 1, 0.001);
}

TEST(Smoothing, leavesOpposingSheetsApart) {
  OrientedPoints sheets{
      test::joined(test::planePoints(4000, 0), test::planePoints(4000, 0.02, 0, 2)),
      Points::Zero(8000, 3)};
  sheets.normals.col(2) << -Vector::Ones(4000), Vector::Ones(4000);
  const Points before = sheets.points;
  const NeighborTable neighbors = NeighborSearch(sheets.points).table(32);
  smooth(neighbors, spacing(sheets.points, neighbors), 0.2, sheets);
  EXPECT_LT((sheets.points - before).cwiseAbs().maxCoeff(), 1e-9);
}

}  // namespace
}  // namespace posture
