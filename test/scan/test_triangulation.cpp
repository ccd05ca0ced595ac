// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "noisy/agreement.h"
#include "noisy/tangent_delaunay.h"
#include "scan_shapes.h"
#include <algorithm>
#include <set>

namespace posture {
namespace {

OrientedPoints upward(const Points& points) {
  OrientedPoints oriented{points, Points::Zero(points.rows(), 3)};
  oriented.normals.col(2).setOnes();
  return oriented;
}

std::vector<TangentTriangle> candidatesOf(const OrientedPoints& oriented) {
  const NeighborSearch search(oriented.points);
  const NeighborTable neighbors = search.table(32);
  return tangentDelaunay(oriented, search, neighbors, spacing(oriented.points, neighbors));
}

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

TEST(TangentDelaunay, IsThePlanesOwnTriangulationInThePlane) {
  const OrientedPoints plane = upward(test::planePoints(400, 0));
  int looked_at = 0;
  for (const TangentTriangle& c : candidatesOf(plane)) {
    const auto [center, radius] = circumcircle(plane.points, c.corners);
    // At the border, points that would refuse a large circle are out of reach.
    if (radius > 0.1) continue;
    ++looked_at;
    for (int i = 0; i < 400; ++i)
      EXPECT_GT((plane.points.row(i).head(2).transpose() - center).norm(), radius * (1 - 1e-3));
  }
  EXPECT_GT(looked_at, 700);
}

TEST(TangentDelaunay, AllCornersAgreeOnALattice) {
  Points lattice(400, 3);
  for (int i = 0; i < 400; ++i) lattice.row(i) << i % 20, i / 20, 0;
  const OrientedPoints plane = upward(lattice);
  const std::vector<TangentTriangle> candidates = candidatesOf(plane);
  const Faces faces = agreeingFaces(plane, candidates);
  double area = 0;
  for (int f = 0; f < faces.rows(); ++f) {
    const Eigen::RowVector3d a = lattice.row(faces(f, 0)), b = lattice.row(faces(f, 1)),
                             c = lattice.row(faces(f, 2));
    const double face_area = (b - a).cross(c - a).z() / 2;
    EXPECT_GT(face_area, -1e-9);
    area += face_area;
  }
  EXPECT_NEAR(area, 19 * 19, 1e-6);
}

TEST(Agreement, UsesNoEdgeTwiceInADirection) {
  OrientedPoints sphere{test::spherePoints(1500, 0.01), {}};
  sphere.normals = sphere.points.rowwise().normalized();
  const Faces faces = agreeingFaces(sphere, candidatesOf(sphere));
  std::set<std::pair<int, int>> directed;
  for (int f = 0; f < faces.rows(); ++f)
    for (int k = 0; k < 3; ++k)
      EXPECT_TRUE(directed.emplace(faces(f, k), faces(f, (k + 1) % 3)).second);
  EXPECT_GT(faces.rows(), 2900);
}

}  // namespace
}  // namespace posture
