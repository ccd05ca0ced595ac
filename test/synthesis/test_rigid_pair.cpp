// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/synthesis/rigid_pair.h>

#include <gtest/gtest.h>

#include "body_checks.h"
#include <algorithm>
#include <vector>

namespace posture {
namespace {

BodyOptions small() {
  BodyOptions options;
  options.vertices = 1500;
  return options;
}

TEST(RigidPair, theMotionTakesEachPlaceToItsCounterpart) {
  const RigidPair pair = makeRigidPair(small());
  const std::vector<VertexPair> truth = groundTruth(pair.source, pair.target);
  const double edge = test::meanEdgeOf(pair.target.mesh);
  double there = 0, here = 0;
  for (const VertexPair& match : truth) {
    const Eigen::Vector3d from = pair.source.mesh.vertices.row(match.source),
                          to = pair.target.mesh.vertices.row(match.target);
    there += (pair.T_target_source * from - to).norm() / static_cast<double>(truth.size());
    here += (from - to).norm() / static_cast<double>(truth.size());
  }
  EXPECT_LT(there, 0.6 * edge);  // the nearest vertex of another tessellation
  EXPECT_GT(here, edge);
}

TEST(RigidPair, eachSideHasWhatTheOtherLacks) {
  const RigidPair pair = makeRigidPair(small());
  // The quadruped is longest along y, its tail is at the low end.
  Vector source(pair.source.mesh.vertices.rows());
  for (int v = 0; v < source.size(); ++v)
    source[v] = (pair.T_target_source * pair.source.mesh.vertices.row(v).transpose()).y();
  const auto target = pair.target.mesh.vertices.col(1);
  const double length = source.maxCoeff() - target.minCoeff();
  EXPECT_NEAR((source.minCoeff() - target.minCoeff()) / length, 0.2, 0.02);
  EXPECT_NEAR((source.maxCoeff() - target.maxCoeff()) / length, 0.2, 0.02);
  EXPECT_LT(groundTruth(pair.source, pair.target).size(), 0.9 * static_cast<double>(source.size()));
  EXPECT_LT(groundTruth(pair.target, pair.source).size(), static_cast<std::size_t>(target.size()));
  EXPECT_EQ(pair.source.rest_position.rows(), pair.source.mesh.vertices.rows());
  EXPECT_LT(pair.source.mesh.faces.maxCoeff(), pair.source.mesh.vertices.rows());
  EXPECT_GE(pair.source.mesh.faces.minCoeff(), 0);
}

TEST(RigidPair, noiseDiffersBetweenTheSides) {
  BodyOptions noisy = small();
  noisy.noise = 0.003;
  const RigidPair clean = makeRigidPair(small()), disturbed = makeRigidPair(noisy);
  const auto noise = [&](const ArticulatedBody& before, const ArticulatedBody& after) -> Vector {
    return (after.mesh.vertices - before.mesh.vertices).rowwise().norm();
  };
  const Vector of_source = noise(clean.source, disturbed.source),
               of_target = noise(clean.target, disturbed.target);
  EXPECT_GT(of_source.mean(), 0);
  EXPECT_GT(of_target.mean(), 0);
  const auto n = std::min(of_source.size(), of_target.size());
  EXPECT_GT((of_source.head(n) - of_target.head(n)).cwiseAbs().mean(), 0.1 * of_source.mean());
  EXPECT_THROW(makeRigidPair({BodyKind::HUMAN, 0, 10}), std::invalid_argument);
}

}  // namespace
}  // namespace posture
