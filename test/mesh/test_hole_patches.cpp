// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/mesh/areas.h>
#include <posture/mesh/edges.h>
#include <posture/mesh/half_edge_mesh.h>
#include <posture/mesh/hole_patches.h>

#include <gtest/gtest.h>

#include "support/shapes.h"
#include <algorithm>
#include <cmath>
#include <vector>

namespace posture {
namespace {

/// Without the faces that have a corner within `radius` of `center`.
TriangleMesh punched(TriangleMesh mesh, const Eigen::RowVector3d& center, double radius) {
  int kept = 0;
  for (int f = 0; f < mesh.faces.rows(); ++f) {
    bool inside = false;
    for (int c = 0; c < 3; ++c)
      inside = inside || (mesh.vertices.row(mesh.faces(f, c)) - center).norm() < radius;
    if (!inside) mesh.faces.row(kept++) = mesh.faces.row(f).eval();
  }
  mesh.faces.conservativeResize(kept, 3);
  return mesh;
}

TriangleMesh patched(TriangleMesh mesh, const HolePatches& patches) {
  const auto n = mesh.vertices.rows(), m = mesh.faces.rows();
  mesh.vertices.conservativeResize(n + patches.vertices.rows(), 3);
  mesh.vertices.bottomRows(patches.vertices.rows()) = patches.vertices;
  mesh.faces.conservativeResize(m + patches.faces.rows(), 3);
  mesh.faces.bottomRows(patches.faces.rows()) = patches.faces;
  return mesh;
}

int boundaryEdges(const TriangleMesh& mesh) {
  const std::vector<Edge> edges = meshEdges(mesh.faces);
  return static_cast<int>(
      std::count_if(edges.begin(), edges.end(), [](const Edge& e) { return e.faces == 1; }));
}

/// Open at both ends, along z.
TriangleMesh tube(double radius, double length, int around, int along) {
  TriangleMesh mesh;
  mesh.vertices.resize(around * (along + 1), 3);
  mesh.faces.resize(2 * around * along, 3);
  const auto number = [&](int i, int j) { return j * around + i % around; };
  for (int j = 0; j <= along; ++j)
    for (int i = 0; i < around; ++i) {
      const double angle = 2 * M_PI * i / around;
      mesh.vertices.row(number(i, j)) << radius * std::cos(angle), radius * std::sin(angle),
          length * j / along;
      if (j == along) continue;
      const int f = 2 * (j * around + i);
      mesh.faces.row(f) << number(i, j), number(i + 1, j), number(i + 1, j + 1);
      mesh.faces.row(f + 1) << number(i, j), number(i + 1, j + 1), number(i, j + 1);
    }
  return mesh;
}

TEST(HolePatches, closeASphereRoundly) {
  for (const double radius : {0.15, 0.4, 0.8}) {
    const TriangleMesh sphere = punched(test::sphere(4), {0, 0, 1}, radius);
    const HolePatches patches = patchHoles(sphere);
    ASSERT_EQ(patches.holes, 1);
    const TriangleMesh whole = patched(sphere, patches);
    EXPECT_EQ(boundaryEdges(whole), 0);
    EXPECT_NO_THROW(HalfEdgeMesh(whole.faces, static_cast<int>(whole.vertices.rows())));
    // A flat patch would be off by radius^2 / 2.
    EXPECT_LT((patches.vertices.rowwise().norm().array() - 1).abs().maxCoeff(),
              0.15 * radius * radius);
    EXPECT_NEAR(faceAreas(whole).sum() / faceAreas(test::sphere(4)).sum(), 1, 0.01);
    EXPECT_NEAR(meanEdgeLength({whole.vertices, patches.faces}) / meanEdgeLength(sphere), 1, 0.3);
  }
}

TEST(HolePatches, closeEveryShortRim) {
  TriangleMesh sphere = test::sphere(4);
  for (const Eigen::RowVector3d& center :
       {Eigen::RowVector3d(1, 0, 0), Eigen::RowVector3d(0, -1, 0), Eigen::RowVector3d(0, 0, 1)})
    sphere = punched(sphere, center, 0.2);
  EXPECT_EQ(patchHoles(sphere).holes, 3);
  // The ends of a long tube, which no patch goes on smoothly from.
  const TriangleMesh closed = tube(0.1, 6, 20, 200);
  EXPECT_EQ(boundaryEdges(patched(closed, patchHoles(closed))), 0);
}

TEST(HolePatches, leaveTheEndsOfATubeAndTheBorderOfASheet) {
  EXPECT_EQ(patchHoles(tube(1, 3, 40, 20)).holes, 0);
  const TriangleMesh sheet = test::grid(30, 30, 1, 1);
  EXPECT_EQ(patchHoles(sheet).holes, 0);
  const TriangleMesh holed = punched(sheet, {0.5, 0.5, 0}, 0.2);
  const HolePatches patches = patchHoles(holed);
  EXPECT_EQ(patches.holes, 1);
  EXPECT_LT(patches.vertices.col(2).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_NEAR(faceAreas(patched(holed, patches)).sum(), 1, 1e-3);
}

TEST(HolePatches, areNotNeededByAClosedSurface) {
  const HolePatches patches = patchHoles(test::sphere(2));
  EXPECT_EQ(patches.holes, 0);
  EXPECT_EQ(patches.vertices.rows(), 0);
  EXPECT_EQ(patches.faces.rows(), 0);
}

TEST(HolePatches, closeAHoleOfOneFace) {
  TriangleMesh sphere = test::sphere(2);
  sphere.faces.conservativeResize(sphere.faces.rows() - 1, 3);
  EXPECT_EQ(boundaryEdges(sphere), 3);
  EXPECT_EQ(boundaryEdges(patched(sphere, patchHoles(sphere))), 0);
}

/// A plate with a round hole of radius 1 that long thin faces lead to.
TEST(HolePatches, doNotOvershootBesideLongFaces) {
  constexpr int RIM = 48;
  for (const double reach : {2.0, 10.0, 50.0}) {
    TriangleMesh plate;
    plate.vertices.resize(2 * RIM, 3);
    plate.faces.resize(2 * RIM, 3);
    for (int i = 0; i < RIM; ++i) {
      const double angle = 2 * M_PI * i / RIM;
      const int j = (i + 1) % RIM;
      plate.vertices.row(i) << std::cos(angle), std::sin(angle), 0;
      // Four corners, twelve points at each.
      const double corner = 2 * M_PI * (i / 12) * 12 / RIM;
      plate.vertices.row(RIM + i) << reach * std::cos(corner) + 1e-3 * i,
          reach * std::sin(corner) + 1e-3 * i, 0;
      plate.faces.row(2 * i) << i, RIM + i, j;
      plate.faces.row(2 * i + 1) << j, RIM + i, RIM + j;
    }
    // Patches have no more vertices than the mesh: some beside it.
    plate = test::joined(plate, test::shifted(test::grid(30, 30, 1, 1), {0, 0, 100}));
    const HolePatches patches = patchHoles(plate);
    ASSERT_EQ(patches.holes, 1);
    EXPECT_LT(faceAreas(patched(plate, patches)).sum() - faceAreas(plate).sum(), 3 * M_PI);
  }
}

TEST(HolePatches, closeNoCutsThatAreNotHoles) {
  // A fin on a sphere: its edge on the sphere has three faces, its own border is none of a hole.
  TriangleMesh mesh = test::sphere(3);
  const auto n = mesh.vertices.rows(), m = mesh.faces.rows();
  mesh.vertices.conservativeResize(n + 1, 3);
  mesh.vertices.row(n) = 1.3 * mesh.vertices.row(mesh.faces(0, 0));
  mesh.faces.conservativeResize(m + 1, 3);
  mesh.faces.row(m) << mesh.faces(0, 0), mesh.faces(0, 1), static_cast<int>(n);
  EXPECT_EQ(patchHoles(mesh).holes, 0);
}

TEST(HolePatches, holdHolesThatTouchAtAVertex) {
  // Two stars that share a vertex of their rims.
  TriangleMesh sheet = test::grid(20, 20, 1, 1);
  sheet = punched(punched(sheet, {0.45, 0.5, 0}, 0.01), {0.55, 0.5, 0}, 0.01);
  const HolePatches patches = patchHoles(sheet);
  const TriangleMesh whole = patched(sheet, patches);
  EXPECT_GE(patches.holes, 1);
  EXPECT_EQ(boundaryEdges(whole), 80);  // the border
  EXPECT_NEAR(faceAreas(whole).sum(), 1, 1e-2);
}

TEST(HolePatches, takeAFineBorderInTheirStride) {
  // A border of six thousand edges.
  const HolePatches patches = patchHoles(test::grid(3000, 4, 10, 0.01));
  EXPECT_EQ(patches.holes, 0);
}

}  // namespace
}  // namespace posture
