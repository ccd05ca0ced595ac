// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/mesh/edges.h>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "support/bodies.h"
#include "whole_source.h"

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

}  // namespace
}  // namespace posture
