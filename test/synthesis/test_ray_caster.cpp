// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/rng.h>
#include <posture/synthesis/ray_caster.h>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "body_checks.h"
#include "support/bodies.h"
#include "support/shapes.h"
#include <cmath>
#include <limits>

namespace posture {
namespace {

using namespace test;

/// By the plane of each face and the three areas beside the point in it.
double nearestOfAll(const TriangleMesh& mesh,
                    const Eigen::Vector3d& origin,
                    const Eigen::Vector3d& direction) {
  double best = std::numeric_limits<double>::infinity();
  for (Eigen::Index f = 0; f < mesh.faces.rows(); ++f) {
    const Eigen::Vector3d a = mesh.vertices.row(mesh.faces(f, 0)),
                          b = mesh.vertices.row(mesh.faces(f, 1)),
                          c = mesh.vertices.row(mesh.faces(f, 2));
    const Eigen::Vector3d normal = (b - a).cross(c - a);
    const double distance = normal.dot(a - origin) / normal.dot(direction);
    const Eigen::Vector3d p = origin + distance * direction;
    const bool inside = normal.dot((b - a).cross(p - a)) >= 0 &&
                        normal.dot((c - b).cross(p - b)) >= 0 &&
                        normal.dot((a - c).cross(p - c)) >= 0;
    if (inside && distance >= 0) best = std::min(best, distance);
  }
  return best;
}

TEST(RayCaster, agreesWithLookingAtEveryFace) {
  const TriangleMesh mesh = makeBody(bodyOptions(BodyKind::HUMAN, 5)).mesh;
  const RayCaster caster(mesh);
  Rng rng(1);
  int hits = 0;
  for (int i = 0; i < 400; ++i) {
    const Eigen::Vector3d origin(rng.normal(), rng.normal(), rng.normal());
    const Eigen::Vector3d aim =
        mesh.vertices.row(rng.below(static_cast<int>(mesh.vertices.rows())));
    const Eigen::Vector3d beside(rng.normal(), rng.normal(), rng.normal());
    const Eigen::Vector3d direction = aim + 0.05 * beside - origin;
    const RayHit hit = caster.cast(origin, direction);
    const double expected = nearestOfAll(mesh, origin, direction);
    ASSERT_EQ(hit.face >= 0, std::isfinite(expected)) << i;
    if (hit.face < 0) continue;
    ++hits;
    ASSERT_NEAR(hit.distance, expected, 1e-9) << i;
    Eigen::Vector3d place = Eigen::Vector3d::Zero();
    for (int corner = 0; corner < 3; ++corner)
      place +=
          hit.barycentric[corner] * mesh.vertices.row(mesh.faces(hit.face, corner)).transpose();
    ASSERT_LT((origin + hit.distance * direction - place).norm(), 1e-9) << i;
  }
  EXPECT_GT(hits, 100);
  EXPECT_LT(hits, 390);
}

TEST(RayCaster, meetsSidesEdgesAndAxesAlike) {
  const TriangleMesh mesh = grid(4, 4, 4, 4);  // in z = 0
  const RayCaster caster(mesh);
  for (double x = 0; x <= 4; x += 0.5)
    for (double y = 0; y <= 4; y += 0.5) {
      EXPECT_EQ(caster.cast({x, y, 2}, {0, 0, -1}).distance, 2) << x << ' ' << y;
      EXPECT_EQ(caster.cast({x, y, -2}, {0, 0, 4}).distance, 0.5) << x << ' ' << y;
      EXPECT_EQ(caster.cast({x, y, 2}, {0, 0, 1}).face, -1);
    }
  EXPECT_EQ(caster.cast({-1, 2, 1}, {1, 0, 0}).face, -1);
  EXPECT_EQ(caster.cast({5, 2, 1}, {0, 0, -1}).face, -1);
}

TEST(RayCaster, ofNothingMeetsNothing) {
  EXPECT_EQ(RayCaster(TriangleMesh()).cast({0, 0, 0}, {0, 0, 1}).face, -1);
  TriangleMesh wrong = grid(1, 1, 1, 1);
  wrong.faces(0, 0) = 9;
  EXPECT_THROW(RayCaster{wrong}, std::invalid_argument);
}

}  // namespace
}  // namespace posture
