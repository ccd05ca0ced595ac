// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/mesh/areas.h>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "refined/completion/whole_source.h"
#include "support/bodies.h"
#include "support/shapes.h"

namespace posture {
namespace {

TEST(WholeSource, whatHasNoCounterpartLiesAsTheRestGoes) {
  constexpr double SCALE = 3;
  const TriangleMesh body = test::person(0, 0).mesh;
  const CleanMesh clean = cleanMesh(body);
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(1, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  const Points there = SCALE * body.vertices * turn.transpose();
  RegistrationResult result;
  result.scale = SCALE;
  result.deformed = there;
  result.correspondence.on_target.resize(body.vertices.rows());
  for (int v = 0; v < body.vertices.rows(); ++v)
    if (body.vertices(v, 0) < 0)
      result.correspondence.on_target[v].vertex = v;
    else
      result.deformed.row(v).setZero();
  const Points laid = restLaid({body, clean}, result);
  EXPECT_LT((laid - there).rowwise().norm().maxCoeff(), 0.01 * SCALE * rootArea(body));
}

TEST(WholeSource, aPieceThatHasItsPlaceKeepsIt) {
  const TriangleMesh large = test::person(0, 0).mesh;
  const auto n = large.vertices.rows();
  const TriangleMesh small =
      test::shifted({0.3 * large.vertices, large.faces}, {10 * rootArea(large), 0, 0});
  const TriangleMesh body = test::joined(large, small);
  const CleanMesh clean = cleanMesh(body);
  RegistrationResult result;
  result.scale = 1;
  result.deformed = body.vertices;
  result.deformed.bottomRows(n).array() += 7;  // placed by itself
  result.correspondence.on_target.resize(2 * n);
  for (int v = 0; v < 2 * n; ++v)
    if (v >= n || body.vertices(v, 0) < 0) result.correspondence.on_target[v].vertex = 0;
  const Points laid = restLaid({body, clean}, result);
  EXPECT_EQ(laid.bottomRows(n), result.deformed.bottomRows(n));
}

}  // namespace
}  // namespace posture
