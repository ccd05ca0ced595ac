// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "candidates.h"
#include "noisy/agreement.h"
#include "scan_shapes.h"
#include <set>
#include <utility>
#include <vector>

namespace posture {
namespace {

TEST(Agreement, allCornersAgreeOnALattice) {
  Points lattice(400, 3);
  for (int i = 0; i < 400; ++i) lattice.row(i) << i % 20, i / 20, 0;
  const OrientedPoints plane = test::upward(lattice);
  const std::vector<TangentTriangle> candidates = test::candidatesOf(plane);
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

TEST(Agreement, usesNoEdgeTwiceInADirection) {
  OrientedPoints sphere{test::spherePoints(1500, 0.01), {}};
  sphere.normals = sphere.points.rowwise().normalized();
  const Faces faces = agreeingFaces(sphere, test::candidatesOf(sphere));
  std::set<std::pair<int, int>> directed;
  for (int f = 0; f < faces.rows(); ++f)
    for (int k = 0; k < 3; ++k)
      EXPECT_TRUE(directed.emplace(faces(f, k), faces(f, (k + 1) % 3)).second);
  EXPECT_GT(faces.rows(), 2900);
}

}  // namespace
}  // namespace posture
