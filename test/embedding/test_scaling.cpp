// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/rng.h>
#include <posture/embedding/scaling.h>

#include <gtest/gtest.h>

#include "support/shapes.h"

namespace posture {
namespace {

using test::pairwise;
using test::randomPoints;

Table ones(Eigen::Index size) { return Table::Ones(size, size); }

TEST(ClassicalScaling, findsPointsThatAreAlreadyEuclidean) {
  for (int count : {4, 5, 60}) {
    const Matrix distances = pairwise(randomPoints(count, count));
    EXPECT_LT((pairwise(classicalScaling(distances)) - distances).cwiseAbs().maxCoeff(), 1e-8);
  }
}

TEST(ClassicalScaling, ordersAxesAndCentres) {
  const Points found = classicalScaling(pairwise(randomPoints(50, 3)));
  EXPECT_LT(found.colwise().mean().norm(), 1e-9);
  EXPECT_GE(found.col(0).norm(), found.col(1).norm());
  EXPECT_GE(found.col(1).norm(), found.col(2).norm());
}

TEST(ClassicalScaling, standsEigenvaluesThatAreManyTimesTheSame) {
  for (const int count : {4, 30, 200}) {  // a simplex, then a point
    const Matrix apart = Matrix::Ones(count, count) - Matrix::Identity(count, count);
    const Points corners = classicalScaling(apart);
    EXPECT_NEAR(
        (corners.transpose() * corners - 0.5 * Eigen::Matrix3d::Identity()).norm(), 0, 1e-9);
    EXPECT_NEAR(classicalScaling(0 * apart).norm(), 0, 1e-9);
  }
}

TEST(ClassicalScaling, refusesTooFew) {
  EXPECT_THROW(classicalScaling(Matrix::Zero(3, 3)), std::invalid_argument);
  EXPECT_THROW(classicalScaling(Matrix::Zero(5, 4)), std::invalid_argument);
}

TEST(LeastSquaresScaling, restoresEuclideanPointsFromADisturbedStart) {
  const Points truth = randomPoints(40, 5);
  const Matrix distances = pairwise(truth);
  const Points start = truth + 0.1 * randomPoints(40, 6);
  const Points found = leastSquaresScaling(distances, ones(40), start);
  EXPECT_LT(normalizedStress(distances, ones(40), found),
            1e-2 * normalizedStress(distances, ones(40), start));
}

/// Distances that no points in space have: those along a circle.
Matrix circleDistances(int count) {
  Matrix distances(count, count);
  for (int i = 0; i < count; ++i)
    for (int j = 0; j < count; ++j) {
      const int steps = std::abs(i - j);
      distances(i, j) = std::min(steps, count - steps);
    }
  return distances;
}

TEST(LeastSquaresScaling, neverEndsWorseThanItBegan) {
  const int count = 60;
  const Matrix distances = circleDistances(count);
  const Points start = classicalScaling(distances);
  const Points found = leastSquaresScaling(distances, ones(count), start);
  EXPECT_LT(normalizedStress(distances, ones(count), found),
            normalizedStress(distances, ones(count), start));
}

TEST(LeastSquaresScaling, doesNotDependOnTheUnit) {
  const int count = 60;
  const Matrix distances = circleDistances(count);
  const Points start = classicalScaling(distances);
  const Points found = leastSquaresScaling(distances, ones(count), start);
  for (const double unit : {0x1p-40, 0x1p+40})
    EXPECT_EQ(leastSquaresScaling(unit * distances, ones(count), unit * start) / unit, found);
}

TEST(LeastSquaresScaling, believesTheWeights) {
  // One distance is wrong by a factor of three: without weight it does no harm.
  const Points truth = randomPoints(30, 7);
  Matrix distances = pairwise(truth);
  distances(3, 9) *= 3;
  distances(9, 3) *= 3;
  Table weights = ones(30);
  weights(3, 9) = weights(9, 3) = 0;
  const Points found = leastSquaresScaling(distances, weights, classicalScaling(distances));
  EXPECT_LT(normalizedStress(distances, weights, found), 1e-3);
  EXPECT_NEAR((found.row(3) - found.row(9)).norm(), (truth.row(3) - truth.row(9)).norm(), 0.02);
}

TEST(LeastSquaresScaling, restsWhereTheStressHasNoSlope) {
  const Matrix distances = circleDistances(20);
  const Points found = leastSquaresScaling(distances, ones(20), classicalScaling(distances));
  const double stress = normalizedStress(distances, ones(20), found);
  // Central differences over the found minimum: no direction lowers the stress notably.
  for (int i = 0; i < found.size(); i += 7) {
    Points there = found;
    constexpr double STEP = 1e-3;
    there.data()[i] += STEP;
    const double above = normalizedStress(distances, ones(20), there);
    there.data()[i] -= 2 * STEP;
    const double below = normalizedStress(distances, ones(20), there);
    EXPECT_LT(std::abs(above - below) / (2 * STEP), 1e-3 * stress);
  }
}

}  // namespace
}  // namespace posture
