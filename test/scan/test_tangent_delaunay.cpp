// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "candidates.h"
#include "noisy/tangent_delaunay.h"
#include "scan_shapes.h"
#include <array>
#include <utility>

namespace posture {
namespace {

/// Radius of the circle through three points of the plane, and its centre.
std::pair<Eigen::Vector2d, double> circumcircle(const Points& p, const std::array<int, 3>& t) {
  const Eigen::Vector2d a = p.row(t[0]).head(2), b = p.row(t[1]).head(2), c = p.row(t[2]).head(2);
  Eigen::Matrix2d sides;
  sides.row(0) = b - a;
  sides.row(1) = c - a;
  const Eigen::Vector2d squares((b - a).squaredNorm() / 2, (c - a).squaredNorm() / 2);
  const Eigen::Vector2d offset = sides.inverse() * squares;
  return {a + offset, offset.norm()};
}

TEST(TangentDelaunay, isThePlanesOwnTriangulationInThePlane) {
  const OrientedPoints plane = test::upward(test::planePoints(400, 0));
  int looked_at = 0;
  for (const TangentTriangle& c : test::candidatesOf(plane)) {
    const auto [center, radius] = circumcircle(plane.points, c.corners);
    // At the border, points that would refuse a large circle are out of reach.
    if (radius > 0.1) continue;
    ++looked_at;
    for (int i = 0; i < 400; ++i)
      EXPECT_GT((plane.points.row(i).head(2).transpose() - center).norm(), radius * (1 - 1e-3));
  }
  EXPECT_GT(looked_at, 700);
}

}  // namespace
}  // namespace posture
