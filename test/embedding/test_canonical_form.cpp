// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/embedding/canonical_form.h>
#include <posture/mesh/edges.h>

#include <gtest/gtest.h>

#include "support/shapes.h"
#include <cmath>
#include <stdexcept>

namespace posture {
namespace {

CanonicalForm formOf(const TriangleMesh& mesh) {
  return computeCanonicalForm(computeLandmarks(mesh, FastMarching(mesh)));
}

Vector pairwise(const Points& points) {
  Vector distances(points.rows() * points.rows());
  for (int i = 0; i < points.rows(); ++i)
    distances.segment(i * points.rows(), points.rows()) =
        (points.rowwise() - points.row(i)).rowwise().norm();
  return distances;
}

TEST(CanonicalForm, flattensABentStripBackIntoThePlane) {
  const TriangleMesh flat = test::grid(30, 8, 4, 1), bent = test::bentStrip(30, 8, 4, 1, 2.5);
  const CanonicalForm form = formOf(bent);
  EXPECT_LT(form.stress, 0.005);
  // Every vertex, sample or projected, keeps its distances to all others.
  const Vector expected = pairwise(flat.vertices), found = pairwise(form.vertices);
  EXPECT_LT((expected - found).cwiseAbs().maxCoeff(), 0.5 * meanEdgeLength(flat));
  EXPECT_LT((expected - found).cwiseAbs().mean(), 0.05 * meanEdgeLength(flat));
}

TEST(CanonicalForm, doesNotChangeWithTheBend) {
  const TriangleMesh gentle = test::bentStrip(30, 8, 4, 1, 0.5);
  const Vector before = pairwise(formOf(gentle).vertices);
  const Vector after = pairwise(formOf(test::bentStrip(30, 8, 4, 1, 3.0)).vertices);
  EXPECT_LT((before - after).cwiseAbs().mean(), 0.1 * meanEdgeLength(gentle));
}

TEST(CanonicalForm, ofTheSamplesAloneIsTheSame) {
  const TriangleMesh strip = test::bentStrip(30, 8, 4, 1, 2.0);
  const Landmarks landmarks = computeLandmarks(strip, FastMarching(strip));
  const CanonicalForm samples = embedSamples(landmarks), all = computeCanonicalForm(landmarks);
  EXPECT_EQ(samples.landmarks, all.landmarks);
  EXPECT_EQ(samples.eigenvalues, all.eigenvalues);
  EXPECT_EQ(samples.stress, all.stress);
  EXPECT_EQ(samples.vertices.rows(), 0);
}

TEST(CanonicalForm, liesInItsPrincipalFrame) {
  const CanonicalForm form = formOf(test::bentStrip(30, 8, 4, 1, 2.0));
  const double count = static_cast<double>(form.landmarks.rows());
  EXPECT_LT(form.landmarks.colwise().mean().norm(), 1e-9);
  const Eigen::Matrix3d covariance = form.landmarks.transpose() * form.landmarks / count;
  EXPECT_LT((covariance - Eigen::Matrix3d(form.eigenvalues.asDiagonal())).norm(), 1e-9);
  EXPECT_GE(form.eigenvalues[0], form.eigenvalues[1]);
  EXPECT_GE(form.eigenvalues[1], form.eigenvalues[2]);
}

TEST(CanonicalForm, refusesVerticesThatNoSampleReaches) {
  TriangleMesh grid = test::grid(12, 9, 4, 1);
  const CanonicalForm before = embedSamples(computeLandmarks(grid, FastMarching(grid)));
  const auto n = grid.vertices.rows();
  grid.vertices.conservativeResize(n + 1, 3);
  grid.vertices.row(n).setConstant(std::nan(""));  // in no face
  const Landmarks landmarks = computeLandmarks(grid, FastMarching(grid));
  EXPECT_THROW(computeCanonicalForm(landmarks), std::invalid_argument);
  // Samples alone are where they were without it.
  EXPECT_EQ(embedSamples(landmarks).landmarks, before.landmarks);
}

}  // namespace
}  // namespace posture
