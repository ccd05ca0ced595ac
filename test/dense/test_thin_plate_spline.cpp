// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/rng.h>
#include <posture/dense/thin_plate_spline.h>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "support/shapes.h"
#include <cmath>

namespace posture {
namespace {

using test::randomPoints;

/// A smooth bend of space.
Points bend(const Points& points) {
  Points bent = points;
  for (int i = 0; i < points.rows(); ++i) {
    bent(i, 1) += 0.3 * std::sin(points(i, 0));
    bent(i, 2) += 0.2 * points(i, 0) * points(i, 1);
  }
  return bent;
}

double rms(const ThinPlateSpline& spline, const Points& at, const Points& expected) {
  double sum = 0;
  for (int i = 0; i < at.rows(); ++i) sum += (spline(at.row(i)) - expected.row(i)).squaredNorm();
  return std::sqrt(sum / static_cast<double>(at.rows()));
}

TEST(ThinPlateSpline, interpolatesWithoutSmoothing) {
  const Points from = randomPoints(60, 1), to = randomPoints(60, 2);
  EXPECT_LT(rms(ThinPlateSpline(from, to, 0), from, to), 1e-9);
}

TEST(ThinPlateSpline, reproducesAffineMapsWhateverTheSmoothing) {
  const Eigen::Matrix3d linear =
      Eigen::AngleAxisd(1, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix() *
      Eigen::Vector3d(1, 2, 0.5).asDiagonal();
  const auto affine = [&](const Points& p) -> Points {
    return (p * linear).rowwise() + Eigen::RowVector3d(4, 5, 6);
  };
  const Points from = randomPoints(40, 3), elsewhere = randomPoints(40, 4);
  for (double smoothing : {0.0, 0.1, 100.0})
    EXPECT_LT(rms(ThinPlateSpline(from, affine(from), smoothing), elsewhere, affine(elsewhere)),
              1e-8);
  EXPECT_LT(rms(ThinPlateSpline(from, affine(from)), elsewhere, affine(elsewhere)), 1e-8);
}

TEST(ThinPlateSpline, tendsToTheAffineFitAsItIsSmoothed) {
  const Points from = randomPoints(50, 5), to = bend(from);
  Matrix basis(50, 4);
  basis << Vector::Ones(50), from;
  const Points fit = basis * basis.colPivHouseholderQr().solve(Matrix(to));
  EXPECT_LT(rms(ThinPlateSpline(from, to, 1e9), from, fit), 1e-6);
}

TEST(ThinPlateSpline, crossValidationSmoothsNoiseAway) {
  const Points from = randomPoints(300, 6), truth = bend(from);
  const Points noisy = truth + 0.1 * randomPoints(300, 7);
  const ThinPlateSpline chosen(from, noisy);
  EXPECT_GT(chosen.smoothing(), 0);
  EXPECT_LT(rms(chosen, from, truth), 0.6 * rms(ThinPlateSpline(from, noisy, 0), from, truth));
  // Near the best smoothing there is, found by looking at the truth.
  double best = 1e9;
  for (double smoothing = 1e-3; smoothing < 1e4; smoothing *= 2)
    best = std::min(best, rms(ThinPlateSpline(from, noisy, smoothing), from, truth));
  EXPECT_LT(rms(chosen, from, truth), 1.1 * best);
}

TEST(ThinPlateSpline, fallsBackOnFewPointsAndBendsFlatOnes) {
  for (int count : {1, 2, 3, 4}) {
    const Points from = randomPoints(count, 8), to = randomPoints(count, 9);
    EXPECT_LT(rms(ThinPlateSpline(from, to), from, to), 1e-9) << count;
  }
  const Points one_place = Points::Constant(3, 3, 0.5), to = randomPoints(3, 9);
  EXPECT_LT((ThinPlateSpline(one_place, to)(one_place.row(0)) - to.colwise().mean()).norm(), 1e-9);
  EXPECT_LT((ThinPlateSpline(one_place, to, 0)(one_place.row(0)) - to.colwise().mean()).norm(),
            1e-9);
  Points flat = randomPoints(30, 10);
  flat.col(2).setZero();
  EXPECT_LT(rms(ThinPlateSpline(flat, bend(flat), 0), flat, bend(flat)), 1e-8);
}

TEST(ThinPlateSpline, refusesSizesThatDiffer) {
  EXPECT_THROW(ThinPlateSpline(Points(0, 3), Points(0, 3)), std::invalid_argument);
  EXPECT_THROW(ThinPlateSpline(randomPoints(5, 1), randomPoints(4, 1)), std::invalid_argument);
  EXPECT_THROW(ThinPlateSpline(randomPoints(5, 1), randomPoints(5, 1), -1), std::invalid_argument);
}

}  // namespace
}  // namespace posture
