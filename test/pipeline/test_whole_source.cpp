// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/mesh/areas.h>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "refined/completion/whole_source.h"
#include "support/bodies.h"

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
  TriangleMesh body = test::person(0, 0).mesh;
  const auto n = body.vertices.rows();
  const Faces own = body.faces;
  // A small copy beside it.
  body.vertices.conservativeResize(2 * n, 3);
  body.vertices.bottomRows(n) = (0.3 * body.vertices.topRows(n)).rowwise() +
                                Eigen::RowVector3d(10, 0, 0) * rootArea({body.vertices, own});
  body.faces.conservativeResize(2 * own.rows(), 3);
  body.faces.bottomRows(own.rows()) = own.array() + static_cast<int>(n);
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
