// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/mesh/handles.h>
#include <posture/mesh/normals.h>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "clean/clean_points.h"
#include "cleanness_of.h"
#include "scan_shapes.h"
#include "support/topology.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace posture {
namespace {

using Eigen::Vector3d;
using test::eulerNumber;
using test::expectManifold;

struct Found {
  std::optional<PointSurface> surface;
  ReconstructionSummary summary;
};

Found find(const Points& points) {
  Found found;
  found.surface = surfaceOfCleanPoints(points, {}, found.summary);
  return found;
}

int pointsOn(const PointSurface& surface) {
  std::set<int> points(surface.point.begin(), surface.point.end());
  points.erase(-1);
  return static_cast<int>(points.size());
}

TEST(CleanPoints, ofACurveAreOfNoSurface) {
  // A trefoil knot, whose tetrahedra would be as many as pairs of points.
  Points knot(6000, 3);
  for (int i = 0; i < knot.rows(); ++i) {
    const double t = 2 * M_PI * i / static_cast<double>(knot.rows());
    knot.row(i) << std::sin(t) + 2 * std::sin(2 * t), std::cos(t) - 2 * std::cos(2 * t),
        -std::sin(3 * t);
  }
  knot /= 6;
  ASSERT_TRUE(test::cleannessOf(knot).is_clean);
  EXPECT_FALSE(find(knot).surface);
}

TEST(CleanPoints, areAllVerticesOfASphere) {
  const Points points = test::spherePoints(3000, 0);
  const Found found = find(points);
  ASSERT_TRUE(found.surface);
  const TriangleMesh& mesh = found.surface->mesh;
  expectManifold(mesh);
  EXPECT_EQ(pointsOn(*found.surface), 3000);
  EXPECT_EQ(mesh.vertices.rows(), 3000);
  EXPECT_EQ(eulerNumber(mesh), 2);
  EXPECT_EQ(found.summary.boundary_loops, 0);
  const Points normals = vertexNormals(mesh);
  for (int v = 0; v < 3000; ++v) {
    EXPECT_EQ(mesh.vertices.row(v), points.row(found.surface->point[v]));
    EXPECT_GT(normals.row(v).dot(mesh.vertices.row(v)), 0.9);
  }
}

TEST(CleanPoints, keepTheTopologyOfATorus) {
  const Found found = find(test::torusPoints(3000, 1, 0.3));
  ASSERT_TRUE(found.surface);
  expectManifold(found.surface->mesh);
  EXPECT_EQ(eulerNumber(found.surface->mesh), 0);
  EXPECT_EQ(found.summary.boundary_loops, 0);
}

TEST(CleanPoints, makeALimbOfSixPointsAround) {
  const Points points = test::withBall(test::coarseLimb(6, 60, 0.1, 0.15));
  const Found found = find(points);
  ASSERT_TRUE(found.surface);
  const TriangleMesh& mesh = found.surface->mesh;
  expectManifold(mesh);
  EXPECT_EQ(pointsOn(*found.surface), points.rows());
  EXPECT_EQ(found.summary.components, 2);
  EXPECT_EQ(eulerNumber(mesh), 4);
  EXPECT_EQ(found.summary.boundary_loops, 0);
  // All of it lies between the limb's inner and outer circles.
  for (int f = 0; f < mesh.faces.rows(); ++f) {
    const Eigen::RowVector3d center = mesh.vertices(mesh.faces.row(f), Eigen::all).colwise().mean();
    if (center.x() > 2 || center.z() < 0 || center.z() > 0.15 * 59) continue;
    EXPECT_GT(center.head<2>().norm(), 0.05);
  }
}

TEST(CleanPoints, reachAsFarAlongALimbAsItsPointsLieApart) {
  // The sixteen points nearest to any are of its own ring: a spacing of 0.13 at most, steps of 0.7.
  const Points points = test::withBall(test::coarseLimb(40, 12, 0.25, 0.7));
  const Found found = find(points);
  ASSERT_TRUE(found.surface);
  expectManifold(found.surface->mesh);
  EXPECT_EQ(pointsOn(*found.surface), points.rows());
  EXPECT_EQ(found.summary.components, 2);
  EXPECT_EQ(found.summary.boundary_loops, 0);
}

/// Points a unit apart on a board on two legs, which are four wide, eight high and three apart.
Points onTwoLegs() {
  const std::array<Eigen::AlignedBox3d, 3> boxes{{{Vector3d(0, 0, 0), Vector3d(4, 4, 8)},
                                                  {Vector3d(7, 0, 0), Vector3d(11, 4, 8)},
                                                  {Vector3d(0, 0, 8), Vector3d(11, 4, 12)}}};
  const auto isIn = [&](const Vector3d& p) {
    return std::any_of(
        boxes.begin(), boxes.end(), [&](const auto& box) { return box.contains(p); });
  };
  std::vector<Vector3d> on;
  for (int x = 0; x <= 11; ++x)
    for (int y = 0; y <= 4; ++y)
      for (int z = 0; z <= 12; ++z) {
        int around = 0;
        for (int octant = 0; octant < 8; ++octant)
          around +=
              isIn(Vector3d(x, y, z) +
                   0.1 * Vector3d(octant & 1 ? 1 : -1, octant & 2 ? 1 : -1, octant & 4 ? 1 : -1));
        if (around > 0 && around < 8) on.emplace_back(x, y, z);
      }
  Points points(on.size(), 3);
  for (std::size_t i = 0; i < on.size(); ++i) points.row(static_cast<Eigen::Index>(i)) = on[i];
  return points;
}

TEST(CleanPoints, makeNoHandleAcrossAGap) {
  const Points points = onTwoLegs();
  const Found found = find(points);
  ASSERT_TRUE(found.surface);
  expectManifold(found.surface->mesh);
  EXPECT_EQ(Handles(found.surface->mesh).count(), 0);
  EXPECT_EQ(found.summary.components, 1);
  EXPECT_GT(pointsOn(*found.surface), 0.97 * static_cast<double>(points.rows()));
}

TEST(CleanPoints, keepSheetsApartThatAreNearlyAsCloseAsTheirPoints) {
  // A spacing of 0.065: a shell 0.1 thick, and a ball 0.1 beside it.
  const Points sphere = test::spherePoints(3000, 0);
  Points beside = test::spherePoints(3000, 0, 2);
  beside.col(0).array() += 2.2;
  const Found found =
      find(test::joined(test::joined(sphere, 1.1 * test::spherePoints(3000, 0, 3)), beside));
  ASSERT_TRUE(found.surface);
  const TriangleMesh& mesh = found.surface->mesh;
  expectManifold(mesh);
  EXPECT_EQ(found.summary.components, 3);
  EXPECT_EQ(eulerNumber(mesh), 6);
  // The inner side of the shell looks inwards.
  const Points normals = vertexNormals(mesh);
  int inner = 0;
  for (int v = 0; v < mesh.vertices.rows(); ++v) {
    const double radius = mesh.vertices.row(v).norm();
    if (std::abs(radius - 1) < 1e-9) {
      EXPECT_LT(normals.row(v).dot(mesh.vertices.row(v)), 0);
      ++inner;
    }
  }
  EXPECT_GT(inner, 0);
}

TEST(CleanPoints, leaveTheRimOfAHalfSphereOpen) {
  const Points all = test::spherePoints(6000, 0);
  std::vector<int> rows;
  for (int i = 0; i < all.rows(); ++i)
    if (all(i, 2) > 0) rows.push_back(i);
  const Found found = find(all(rows, Eigen::all));
  ASSERT_TRUE(found.surface);
  const TriangleMesh& mesh = found.surface->mesh;
  expectManifold(mesh);
  EXPECT_EQ(found.summary.components, 1);
  EXPECT_EQ(found.summary.boundary_loops, 1);
  EXPECT_EQ(eulerNumber(mesh), 1);
  for (int f = 0; f < mesh.faces.rows(); ++f) {
    const Eigen::RowVector3d center = mesh.vertices(mesh.faces.row(f), Eigen::all).colwise().mean();
    EXPECT_GT(center.norm(), 0.97);
  }
}

TEST(CleanPoints, leaveOutliersOut) {
  Rng rng(6);
  Points wild(150, 3);
  for (int i = 0; i < wild.size(); ++i) wild.data()[i] = 4 * rng.uniform() - 2;
  const Found found = find(test::joined(wild, test::spherePoints(3000, 0)));
  ASSERT_TRUE(found.surface);
  const TriangleMesh& mesh = found.surface->mesh;
  EXPECT_EQ(found.summary.components, 1);
  EXPECT_EQ(eulerNumber(mesh), 2);
  int on_sphere = 0;
  for (int v = 0; v < mesh.vertices.rows(); ++v) {
    const double height = std::abs(mesh.vertices.row(v).norm() - 1);
    EXPECT_LT(height, 0.4);  // six spacings
    on_sphere += height < 1e-9 && found.surface->point[v] >= 150;
  }
  EXPECT_GE(on_sphere, 2990);
}

TEST(CleanPoints, areNotTakenForASurfaceWhereTheyAreNone) {
  EXPECT_FALSE(find(test::spherePoints(3000, 0.02)).surface);
  EXPECT_FALSE(find(test::planePoints(1000, 0)).surface);
  Rng rng(2);
  Points filled(3000, 3);
  for (int i = 0; i < filled.size(); ++i) filled.data()[i] = rng.uniform();
  const Found found = find(filled);
  EXPECT_FALSE(found.surface);
  EXPECT_EQ(found.summary.spacing, 0);
}

}  // namespace
}  // namespace posture
