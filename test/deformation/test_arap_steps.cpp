// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/rng.h>

#include <Eigen/SparseCholesky>
#include <gtest/gtest.h>

#include "arap_steps.h"
#include <vector>

namespace posture {
namespace {

constexpr int VERTICES = 40;

Eigen::Matrix3d randomMatrix(Rng& rng) {
  Eigen::Matrix3d m;
  for (double& entry : m.reshaped()) entry = rng.normal();
  return m;
}

Points randomPoints(Rng& rng) {
  Points points(VERTICES, 3);
  for (double& x : points.reshaped()) x = rng.normal();
  return points;
}

std::vector<RigidEdge> randomEdges(Rng& rng) {
  std::vector<RigidEdge> edges;
  for (int j = 1; j < VERTICES; ++j)
    for (int i = j % 3; i < j; i += 4)
      edges.push_back(
          {i, j, rng.uniform(), Eigen::RowVector3d(rng.normal(), rng.normal(), rng.normal())});
  return edges;
}

/// Each way of computing them against plain loops, and against each other.
class EveryArapSteps : public testing::TestWithParam<const ArapSteps*> {};

TEST_P(EveryArapSteps, addCovariancesOfTheEdges) {
  Rng rng(1);
  const std::vector<RigidEdge> edges = randomEdges(rng);
  const Points places = randomPoints(rng);
  std::vector<Eigen::Matrix3d> expected;
  std::vector<WideMatrix> sums, portable;
  for (int v = 0; v < VERTICES; ++v) {
    expected.push_back(randomMatrix(rng));
    sums.push_back(wide(expected.back()));
  }
  portable = sums;
  for (const RigidEdge& e : edges)
    for (const int v : {e.i, e.j})
      expected[v] += e.weight * (places.row(e.i) - places.row(e.j)).transpose() * e.rest;
  GetParam()->addCovariances(edges, wideRows(places), sums);
  portableArapSteps().addCovariances(edges, wideRows(places), portable);
  for (int v = 0; v < VERTICES; ++v) {
    EXPECT_TRUE(narrow(sums[v]).isApprox(expected[v], 1e-12)) << v;
    EXPECT_EQ(narrow(sums[v]), narrow(portable[v])) << v;
  }
}

TEST_P(EveryArapSteps, addThePullOfTurnedEdges) {
  Rng rng(2);
  const std::vector<RigidEdge> edges = randomEdges(rng);
  const Points start = randomPoints(rng);
  const Vector stiffness = Vector::LinSpaced(VERTICES, 0.1, 2);
  std::vector<WideMatrix> rotations;
  for (int v = 0; v < VERTICES; ++v) rotations.push_back(wide(randomMatrix(rng)));
  Points expected = start;
  for (const RigidEdge& e : edges) {
    const Eigen::Matrix3d stiff =
        stiffness[e.i] * narrow(rotations[e.i]) + stiffness[e.j] * narrow(rotations[e.j]);
    const Eigen::RowVector3d turned = 0.5 * e.weight * e.rest * stiff.transpose();
    expected.row(e.i) += turned;
    expected.row(e.j) -= turned;
  }
  std::vector<WideRow> pull = wideRows(start), portable = pull;
  GetParam()->addRigidPull(edges, rotations, stiffness, pull);
  portableArapSteps().addRigidPull(edges, rotations, stiffness, portable);
  EXPECT_TRUE(narrowRows(pull).isApprox(expected, 1e-12));
  EXPECT_EQ(narrowRows(pull), narrowRows(portable));
}

TEST_P(EveryArapSteps, solveWithTheFactorsOfASystem) {
  Rng rng(3);
  Matrix dense = Matrix::Zero(VERTICES, VERTICES);
  for (int k = 0; k < 4 * VERTICES; ++k)
    dense(k % VERTICES, static_cast<int>(VERTICES * rng.uniform())) = rng.normal();
  const Matrix system = dense * dense.transpose() + Matrix::Identity(VERTICES, VERTICES);
  const Points right = randomPoints(rng);
  const Eigen::
      SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower, Eigen::NaturalOrdering<int>>
          factors(system.sparseView());
  const auto& lower = factors.matrixL().nestedExpression();
  const Vector inverse_diagonal = factors.vectorD().cwiseInverse();
  std::vector<WideRow> x = wideRows(right), portable = x;
  GetParam()->solve(lower, inverse_diagonal, x);
  portableArapSteps().solve(lower, inverse_diagonal, portable);
  EXPECT_TRUE((system * narrowRows(x)).isApprox(right, 1e-10));
  EXPECT_EQ(narrowRows(x), narrowRows(portable));
}

INSTANTIATE_TEST_SUITE_P(EveryProcessor,
                         EveryArapSteps,
                         testing::Values(&arapSteps(), &portableArapSteps()));

}  // namespace
}  // namespace posture
