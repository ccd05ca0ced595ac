// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "noisy/thinning.h"
#include "scan_shapes.h"
#include "support/shapes.h"

namespace posture {
namespace {

TEST(Thinning, leavesPointsApartAndNoPlaceEmpty) {
  const Points points = test::planePoints(3000, 0);
  OrientedPoints plane{points, Points::Zero(3000, 3)};
  plane.normals.col(2).setOnes();
  const NeighborTable neighbors = NeighborSearch(points).table(32);
  Spacing h = spacing(points, neighbors);
  h.at.assign(3000, 0.03);
  const OrientedPoints thinned = thin(plane, neighbors, h);
  Matrix distances = test::pairwise(thinned.points);
  distances.diagonal().setConstant(1);
  EXPECT_GE(distances.minCoeff(), 0.015);
  const NeighborSearch search(thinned.points);
  for (int i = 0; i < 3000; ++i) EXPECT_FALSE(search.within(points.row(i), 0.01501).empty());
}

TEST(Thinning, keepsBothOfOpposingSheets) {
  OrientedPoints sheets{test::joined(test::planePoints(1000, 0), test::planePoints(1000, 0.001)),
                        Points::Zero(2000, 3)};
  sheets.normals.col(2) << -Vector::Ones(1000), Vector::Ones(1000);
  const NeighborTable neighbors = NeighborSearch(sheets.points).table(32);
  const OrientedPoints thinned = thin(sheets, neighbors, spacing(sheets.points, neighbors));
  const auto upper = (thinned.normals.col(2).array() > 0).count();
  EXPECT_NEAR(static_cast<double>(upper) / static_cast<double>(thinned.points.rows()), 0.5, 0.05);
}

}  // namespace
}  // namespace posture
