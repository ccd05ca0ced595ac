// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <gtest/gtest.h>

#include "clean/delaunay.h"
#include "clean/predicates.h"
#include "scan_shapes.h"
#include <algorithm>
#include <set>

namespace posture {
namespace {

Points randomPoints(int count) {
  Rng rng(4);
  Points points(count, 3);
  for (int i = 0; i < points.size(); ++i) points.data()[i] = rng.uniform();
  return points;
}

/// A lattice: all its cubes have eight points on a sphere, and its sides are planes full of points.
Points lattice(int side) {
  Points points(side * side * side, 3);
  for (int i = 0; i < points.rows(); ++i)
    points.row(i) << i % side, i / side % side, i / side / side;
  return points / side;
}

bool isFinite(const std::array<int, 4>& corners, int n) {
  return *std::max_element(corners.begin(), corners.end()) < n;
}

double volume(const Points& points, const std::array<int, 4>& c) {
  Eigen::Matrix3d edges;
  for (int k = 0; k < 3; ++k) edges.row(k) = points.row(c[k + 1]) - points.row(c[0]);
  return edges.determinant() / 6;
}

/// Every tetrahedron has volume and no point within its sphere, each by more than rounding.
void expectDelaunay(const Points& points, const Tetrahedra& tetrahedra) {
  const int n = static_cast<int>(points.rows());
  for (const std::array<int, 4>& c : tetrahedra.corners) {
    if (!isFinite(c, n)) continue;
    ASSERT_GT(volume(points, c), 0);
    Eigen::Matrix3d edges;
    Eigen::Vector3d squares;
    for (int k = 0; k < 3; ++k) {
      edges.row(k) = points.row(c[k + 1]) - points.row(c[0]);
      squares[k] = edges.row(k).squaredNorm() / 2;
    }
    const Eigen::Vector3d offset = edges.fullPivLu().solve(squares);
    const double radius = offset.norm();
    const Vector distances =
        (points.rowwise() - (points.row(c[0]) + offset.transpose())).rowwise().norm();
    ASSERT_GT(distances.minCoeff(), radius * (1 - 1e-6));
  }
}

/// Neighbours know each other, and the complex is a sphere: with the point at infinity there are as
/// many points and triangles as edges and tetrahedra.
void expectComplex(const Points& points, const Tetrahedra& tetrahedra, int distinct) {
  std::set<int> vertices;
  std::set<std::array<int, 2>> edges;
  std::set<std::array<int, 3>> faces;
  for (int t = 0; t < tetrahedra.size(); ++t) {
    std::array<int, 4> c = tetrahedra.corners[t];
    for (int k = 0; k < 4; ++k) {
      const int beyond = tetrahedra.beyond[t][k], mirror = tetrahedra.mirror(t, k);
      ASSERT_EQ(tetrahedra.beyond[beyond][mirror], t);
      std::array<int, 3> here = tetrahedra.face(t, k), there = tetrahedra.face(beyond, mirror);
      std::sort(here.begin(), here.end());
      std::sort(there.begin(), there.end());
      ASSERT_EQ(here, there);
      faces.insert(here);
    }
    std::sort(c.begin(), c.end());
    for (int a = 0; a < 4; ++a) {
      vertices.insert(c[a]);
      for (int b = a + 1; b < 4; ++b) edges.insert({c[a], c[b]});
    }
  }
  EXPECT_EQ(static_cast<int>(vertices.size()), distinct + 1);
  EXPECT_EQ(*vertices.rbegin(), points.rows());
  EXPECT_EQ(vertices.size() + faces.size(), edges.size() + tetrahedra.corners.size());
}

double totalVolume(const Points& points, const Tetrahedra& tetrahedra) {
  double sum = 0;
  for (const std::array<int, 4>& c : tetrahedra.corners)
    if (isFinite(c, static_cast<int>(points.rows()))) sum += volume(points, c);
  return sum;
}

TEST(Delaunay, hasEmptySpheres) {
  const Points points = randomPoints(500);
  const auto tetrahedra = delaunay(points);
  ASSERT_TRUE(tetrahedra);
  expectDelaunay(points, *tetrahedra);
  expectComplex(points, *tetrahedra, 500);
}

TEST(Delaunay, fillsALatticeWithoutFlatTetrahedra) {
  const Points points = lattice(6);
  const auto tetrahedra = delaunay(points);
  ASSERT_TRUE(tetrahedra);
  expectDelaunay(points, *tetrahedra);
  expectComplex(points, *tetrahedra, 216);
  EXPECT_NEAR(totalVolume(points, *tetrahedra), std::pow(5.0 / 6, 3), 1e-12);
}

TEST(Delaunay, fillsTheHullOfPointsOnASphere) {
  // Rings of points: cospherical, and coplanar ring by ring.
  Points points(10 * 12 + 2, 3);
  for (int i = 0; i < 120; ++i) {
    const double up = M_PI * (i / 12 + 1) / 11, around = 2 * M_PI * (i % 12) / 12;
    points.row(i) << std::sin(up) * std::cos(around), std::sin(up) * std::sin(around), std::cos(up);
  }
  points.row(120) << 0, 0, 1;
  points.row(121) << 0, 0, -1;
  const auto tetrahedra = delaunay(points);
  ASSERT_TRUE(tetrahedra);
  expectComplex(points, *tetrahedra, 122);
  EXPECT_NEAR(totalVolume(points, *tetrahedra), 4 * M_PI / 3, 0.35);
}

TEST(Delaunay, takesOneOfRepeatedPoints) {
  Points points = test::joined(lattice(4), lattice(4));
  const auto tetrahedra = delaunay(points);
  ASSERT_TRUE(tetrahedra);
  expectComplex(points, *tetrahedra, 64);
}

TEST(Delaunay, findsNothingInAPlane) {
  EXPECT_FALSE(delaunay(test::planePoints(200, 0.3)));
  EXPECT_FALSE(delaunay(lattice(5).leftCols<3>().topRows(25)));
  EXPECT_FALSE(delaunay(Points::Constant(5, 3, 0.5)));
}

}  // namespace
}  // namespace posture
