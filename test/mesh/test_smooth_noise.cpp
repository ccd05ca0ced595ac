// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/mesh/edges.h>
#include <posture/mesh/smooth_noise.h>
#include <posture/synthesis/articulated_body.h>

#include <gtest/gtest.h>

#include "support/shapes.h"
#include <cmath>
#include <utility>
#include <vector>

namespace posture {
namespace {

TriangleMesh noisy(TriangleMesh mesh, double edges) {
  const double length = edges * meanEdgeLength(mesh);
  mesh.vertices += length * test::randomPoints(static_cast<int>(mesh.vertices.rows()), 1);
  return mesh;
}

double rootMeanSquareOff(const Points& places, double radius) {
  return std::sqrt((places.rowwise().norm().array() - radius).square().mean());
}

TEST(SmoothNoise, leavesBodiesAsTheyAre) {
  BodyOptions coarse;
  coarse.vertices = 1000;
  for (TriangleMesh mesh : {test::sphere(1),
                            test::sphere(2),
                            test::torus(16, 6, 1, 0.3),
                            test::torus(40, 12, 1, 0.3),
                            test::bentStrip(20, 8, 2, 1, 1),
                            makeBody(coarse).mesh,
                            noisy(test::sphere(4), 0.05)}) {
    const Points before = mesh.vertices;
    EXPECT_EQ(smoothNoise(mesh), 0);
    EXPECT_EQ(mesh.vertices, before);
  }
}

/// A profile of radii and heights, turned about the z axis.
TriangleMesh turned(const std::vector<std::pair<double, double>>& profile, int around) {
  const int rings = static_cast<int>(profile.size());
  TriangleMesh mesh{Points(rings * around, 3), Faces(2 * (rings - 1) * around, 3)};
  for (int i = 0; i < rings; ++i)
    for (int k = 0; k < around; ++k) {
      const double angle = 2 * M_PI * k / around;
      mesh.vertices.row(i * around + k) << profile[i].first * std::cos(angle),
          profile[i].first * std::sin(angle), profile[i].second;
    }
  for (int i = 0; i + 1 < rings; ++i)
    for (int k = 0; k < around; ++k) {
      const int a = i * around + k, b = i * around + (k + 1) % around;
      mesh.faces.row(2 * (i * around + k)) << a, b, b + around;
      mesh.faces.row(2 * (i * around + k) + 1) << a, b + around, a + around;
    }
  return mesh;
}

TEST(SmoothNoise, leavesWhatHasSharpEdgesAllOver) {
  const std::vector<std::pair<double, double>> pawn{
      {1, 0}, {1, 0.3}, {0.4, 0.6}, {0.3, 2}, {0.6, 2.1}, {0.3, 2.3}, {0.5, 2.6}, {0.3, 3}};
  for (int around : {12, 24, 64}) {
    SCOPED_TRACE(around);
    TriangleMesh mesh = turned(pawn, around);
    const Points before = mesh.vertices;
    EXPECT_EQ(smoothNoise(mesh), 0);
    EXPECT_EQ(mesh.vertices, before);
    TriangleMesh rough = noisy(mesh, 0.5);
    EXPECT_GE(smoothNoise(rough), 1);
  }
}

TEST(SmoothNoise, takesNoiseAwayAndKeepsTheSize) {
  for (double edges : {0.3, 1.0}) {
    TriangleMesh mesh = noisy(test::sphere(4), edges);
    const double before = rootMeanSquareOff(mesh.vertices, 1);
    EXPECT_GE(smoothNoise(mesh), 1);
    EXPECT_LT(rootMeanSquareOff(mesh.vertices, 1), 0.5 * before);
    EXPECT_NEAR(mesh.vertices.rowwise().norm().mean(), 1, 0.02);
  }
}

TEST(SmoothNoise, keepsRims) {
  const TriangleMesh plane = test::grid(40, 20, 2, 1);
  TriangleMesh mesh = noisy(plane, 0.3);
  EXPECT_GE(smoothNoise(mesh), 1);
  const Points low = mesh.vertices.colwise().minCoeff(), high = mesh.vertices.colwise().maxCoeff();
  const double edge = meanEdgeLength(plane);
  for (int k = 0; k < 2; ++k) {
    EXPECT_NEAR(low(0, k), plane.vertices.col(k).minCoeff(), edge);
    EXPECT_NEAR(high(0, k), plane.vertices.col(k).maxCoeff(), edge);
  }
}

TEST(SmoothNoise, keepsSmallHolesOpen) {
  const TriangleMesh whole = test::sphere(4);
  TriangleMesh mesh = noisy(whole, 0.3);
  const Eigen::RowVector3i missing = mesh.faces.row(0);
  mesh.faces = Faces(mesh.faces.bottomRows(mesh.faces.rows() - 1));
  EXPECT_GE(smoothNoise(mesh), 1);
  for (int k = 0; k < 3; ++k)
    EXPECT_GT((mesh.vertices.row(missing[k]) - mesh.vertices.row(missing[(k + 1) % 3])).norm(),
              0.5 * meanEdgeLength(whole));
}

TEST(SmoothNoise, doesNotDependOnWhichWayFacesAreTurned) {
  TriangleMesh mesh = noisy(test::sphere(3), 0.3), turned = mesh;
  for (int f = 0; f < turned.faces.rows(); f += 2)
    std::swap(turned.faces(f, 0), turned.faces(f, 1));
  EXPECT_EQ(smoothNoise(mesh), smoothNoise(turned));
  EXPECT_LT((mesh.vertices - turned.vertices).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(SmoothNoise, ofFacetsThatShareNoVertices) {
  TriangleMesh mesh = noisy(test::sphere(3), 0.3), loose = test::soup(mesh);
  EXPECT_EQ(smoothNoise(mesh), smoothNoise(loose));
  EXPECT_LT((test::soup(mesh).vertices - loose.vertices).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(SmoothNoise, leavesWhatIsNoSurface) {
  TriangleMesh none{Points(0, 3), Faces(0, 3)};
  EXPECT_EQ(smoothNoise(none), 0);
  TriangleMesh flat = test::grid(5, 5, 1, 1);
  flat.vertices.setZero();
  EXPECT_EQ(smoothNoise(flat), 0);
}

}  // namespace
}  // namespace posture
