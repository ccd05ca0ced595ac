// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/evaluation/surface_fit.h>

#include <gtest/gtest.h>

#include "support/shapes.h"
#include <cmath>

namespace posture {
namespace {

TEST(SurfaceFit, perfectOnItself) {
  const TriangleMesh mesh = test::sphere(2);
  const SurfaceFit fit = measureFit(mesh, mesh.vertices, 1, mesh);
  EXPECT_NEAR(fit.median_distance, 0, 1e-5);
  EXPECT_NEAR(fit.percentile_95_distance, 0, 1e-5);
  EXPECT_EQ(fit.mean_stretch, 0);
}

TEST(SurfaceFit, stretchIsRelativeToTheScale) {
  const TriangleMesh mesh = test::sphere(2);
  const Points twice = 2 * mesh.vertices;
  EXPECT_NEAR(measureFit(mesh, twice, 1, mesh).mean_stretch, std::log(2.0), 1e-12);
  EXPECT_NEAR(measureFit(mesh, twice, 2, mesh).percentile_95_stretch, 0, 1e-12);
}

TEST(SurfaceFit, distanceIsInTargetEdges) {
  const TriangleMesh target = test::grid(20, 20, 2, 2);
  Points lifted = target.vertices;
  lifted.col(2).array() += 0.5;
  const double edge = (2 * 20 * 21 * 0.1 + 400 * 0.1 * std::sqrt(2.0)) / (2 * 20 * 21 + 400);
  const SurfaceFit fit = measureFit(target, lifted, 1, target);
  EXPECT_NEAR(fit.median_distance, 0.5 / edge, 1e-4);
  EXPECT_NEAR(fit.percentile_95_distance, 0.5 / edge, 1e-4);
}

TEST(SurfaceFit, collapsedEdgesAreAFiniteStretch) {
  const TriangleMesh mesh = test::sphere(1);
  const SurfaceFit fit = measureFit(mesh, Points::Zero(mesh.vertices.rows(), 3), 1, mesh);
  EXPECT_EQ(fit.mean_stretch, 10);
}

TEST(SurfaceFit, refusesWhatDoesNotFit) {
  const TriangleMesh mesh = test::sphere(1);
  EXPECT_THROW(measureFit(mesh, Points::Zero(3, 3), 1, mesh), std::invalid_argument);
}

}  // namespace
}  // namespace posture
