// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "support/shapes.h"
#include "surface/mesh_locator.h"
#include <cmath>
#include <stdexcept>

namespace posture {
namespace {

TEST(MeshLocator, findsNoFartherPlaceThanADenseSearch) {
  const TriangleMesh sphere = test::sphere(2);
  const MeshLocator locator(sphere);
  const Points queries = test::randomPoints(50, 3);
  for (int q = 0; q < 50; ++q) {
    const Eigen::RowVector3d query = queries.row(q);
    const MeshLocator::Place place = locator.nearest(query);
    double nearest = 1e9;
    constexpr int STEPS = 24;
    for (int f = 0; f < sphere.faces.rows(); ++f)
      for (int i = 0; i <= STEPS; ++i)
        for (int j = 0; j + i <= STEPS; ++j) {
          const Eigen::RowVector3d weights(i, j, STEPS - i - j);
          const Eigen::RowVector3d at =
              weights / STEPS * Eigen::Matrix3d(sphere.vertices(sphere.faces.row(f), Eigen::all));
          nearest = std::min(nearest, (at - query).norm());
        }
    EXPECT_LE(place.distance, nearest + 1e-12);
    EXPECT_GE(place.distance, nearest - 0.01);
    const auto corners = sphere.faces.row(place.on_mesh.face);
    const Eigen::RowVector3d at = place.on_mesh.barycentric.transpose() *
                                  Eigen::Matrix3d(sphere.vertices(corners, Eigen::all));
    EXPECT_NEAR((at - query).norm(), place.distance, 1e-12);
    EXPECT_NEAR(place.on_mesh.barycentric.sum(), 1, 1e-12);
    EXPECT_GE(place.on_mesh.barycentric.minCoeff(), 0);
    EXPECT_TRUE((corners.array() == place.on_mesh.vertex).any());
  }
}

TEST(MeshLocator, refusesPlacesToWhichThereIsNoDistance) {
  const TriangleMesh sphere = test::sphere(1);
  const MeshLocator locator(sphere);
  EXPECT_THROW(locator.nearest({1e200, 0, 0}), std::invalid_argument);
  EXPECT_THROW(locator.nearest({0, std::nan(""), 0}), std::invalid_argument);
}

}  // namespace
}  // namespace posture
