// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/mesh/half_edge_mesh.h>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "clean/curvature_flips.h"
#include "support/shapes.h"
#include <algorithm>
#include <cmath>

namespace posture {
namespace {

/// Sum over the inner edges of length times angle between the faces.
double curvature(const TriangleMesh& mesh) {
  const HalfEdgeMesh half_edges(mesh.faces, static_cast<int>(mesh.vertices.rows()));
  const auto normal = [&](int h) {
    const Eigen::Vector3d a = mesh.vertices.row(mesh.faces(h / 3, 0)),
                          b = mesh.vertices.row(mesh.faces(h / 3, 1)),
                          c = mesh.vertices.row(mesh.faces(h / 3, 2));
    return Eigen::Vector3d((b - a).cross(c - a).normalized());
  };
  double sum = 0;
  for (int h = 0; h < half_edges.halfEdgeCount(); ++h) {
    if (half_edges.twin(h) < h) continue;
    const double cosine = std::clamp(normal(h).dot(normal(half_edges.twin(h))), -1.0, 1.0);
    sum +=
        std::acos(cosine) *
        (mesh.vertices.row(half_edges.origin(h)) - mesh.vertices.row(half_edges.target(h))).norm();
  }
  return sum;
}

/// An open prism of six sides, cut across by rings; all its ridges run along it.
TriangleMesh prism(int rings) {
  TriangleMesh mesh{Points(6 * rings, 3), Faces(12 * (rings - 1), 3)};
  for (int i = 0; i < 6 * rings; ++i)
    mesh.vertices.row(i) << std::cos(M_PI * (i % 6) / 3), std::sin(M_PI * (i % 6) / 3),
        1.5 * (i / 6);
  for (int i = 0; i < 6 * (rings - 1); ++i) {
    const int next = i / 6 * 6 + (i + 1) % 6;
    mesh.faces.row(2 * i) << i, next, next + 6;
    mesh.faces.row(2 * i + 1) << i, next + 6, i + 6;
  }
  return mesh;
}

TEST(CurvatureFlips, findTheRidgesOfAPrism) {
  const TriangleMesh whole = prism(8);
  const int n = static_cast<int>(whole.vertices.rows());
  HalfEdgeMesh half_edges(whole.faces, n);
  int turned = 0;
  for (int h = 0; h < half_edges.halfEdgeCount(); h += 31)
    if (half_edges.twin(h) >= 0 && half_edges.canFlip(h)) {
      half_edges.flip(h);
      ++turned;
    }
  ASSERT_GT(turned, 5);
  const TriangleMesh crumpled{whole.vertices, half_edges.faces()};
  ASSERT_GT(curvature(crumpled), 1.05 * curvature(whole));
  const TriangleMesh smooth{whole.vertices, withLessCurvature(crumpled)};
  EXPECT_LT(curvature(smooth), 1.02 * curvature(whole));
  EXPECT_EQ(smooth.faces.rows(), whole.faces.rows());
  EXPECT_TRUE(HalfEdgeMesh(smooth.faces, n).check().empty());
}

TEST(CurvatureFlips, leaveAPlaneAsItIs) {
  const TriangleMesh grid = test::grid(6, 5, 6, 5);
  EXPECT_EQ(withLessCurvature(grid), grid.faces);
}

}  // namespace
}  // namespace posture
