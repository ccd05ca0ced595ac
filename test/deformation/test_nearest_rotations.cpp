// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/rng.h>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "nearest_rotations.h"
#include <cmath>
#include <limits>
#include <vector>

namespace {

using Eigen::Matrix3d, Eigen::Vector3d;

void toNearestRotations(std::vector<Matrix3d>& matrices) {
  std::vector<posture::WideMatrix> wide;
  for (const Matrix3d& m : matrices) wide.push_back(posture::wide(m));
  posture::toNearestRotations(wide);
  for (std::size_t i = 0; i < matrices.size(); ++i) matrices[i] = posture::narrow(wide[i]);
}

Matrix3d randomMatrix(posture::Rng& rng) {
  Matrix3d m;
  for (double& entry : m.reshaped()) entry = 2 * rng.uniform() - 1;
  return m;
}

Matrix3d randomRotation(posture::Rng& rng) {
  const Vector3d axis = randomMatrix(rng).col(0).normalized();
  return Eigen::AngleAxisd(2 * M_PI * rng.uniform(), axis).toRotationMatrix();
}

/// The largest trace of R' m over all rotations R.
double largestTrace(const Matrix3d& m) {
  const Vector3d s = Eigen::JacobiSVD<Matrix3d>(m).singularValues();
  return s[0] + s[1] + (m.determinant() < 0 ? -s[2] : s[2]);
}

void expectNearest(const std::vector<Matrix3d>& given, double tolerance) {
  std::vector<Matrix3d> r = given;
  toNearestRotations(r);
  for (std::size_t i = 0; i < given.size(); ++i) {
    EXPECT_NEAR((r[i].transpose() * r[i] - Matrix3d::Identity()).norm(), 0, tolerance) << i;
    EXPECT_NEAR(r[i].determinant(), 1, tolerance) << i;
    EXPECT_NEAR(
        (r[i].transpose() * given[i]).trace(), largestTrace(given[i]), tolerance * given[i].norm())
        << i;
  }
}

TEST(NearestRotations, haveTheLargestTrace) {
  posture::Rng rng(1);
  std::vector<Matrix3d> given;
  for (int i = 0; i < 203; ++i) given.push_back(std::pow(10.0, i % 9 - 4) * randomMatrix(rng));
  expectNearest(given, 1e-9);
}

TEST(NearestRotations, ofFlatAndMirroredSurroundings) {
  posture::Rng rng(2);
  std::vector<Matrix3d> given;
  for (int i = 0; i < 200; ++i) {
    const double third = i % 4 == 0 ? 0 : std::pow(10.0, -i % 17) * (i % 2 == 0 ? 1 : -1);
    const Vector3d stretch(1, 0.2 + rng.uniform(), third);
    given.emplace_back(randomRotation(rng) * stretch.asDiagonal() * randomRotation(rng));
  }
  expectNearest(given, 1e-8);
}

TEST(NearestRotations, whereOthersAreNearlyAsGood) {
  posture::Rng rng(5);
  std::vector<Matrix3d> given;
  for (int a = 0; a < 18; ++a)
    for (int b = 0; b < 18; ++b) {
      const double near = std::pow(10.0, -a), nearer = std::pow(10.0, -b);
      for (const Vector3d& stretch : {Vector3d(1, 1 - near, -1 + nearer),
                                      Vector3d(1, near, -near),
                                      Vector3d(1, near, 0),
                                      Vector3d(1, near, nearer)})
        given.emplace_back(randomRotation(rng) * stretch.asDiagonal() * randomRotation(rng));
    }
  expectNearest(given, 1e-7);
}

TEST(NearestRotations, doNotDependOnWhatStandsBeside) {
  posture::Rng rng(3);
  std::vector<Matrix3d> together;
  for (int i = 0; i < 20; ++i) together.push_back(randomMatrix(rng));
  together[5].setZero();
  together[6].setConstant(std::numeric_limits<double>::quiet_NaN());
  const std::vector<Matrix3d> given = together;
  toNearestRotations(together);
  for (std::size_t i = 0; i < given.size(); ++i) {
    if (i == 6) {
      EXPECT_TRUE(together[i].array().isNaN().all());
      continue;
    }
    std::vector<Matrix3d> alone{given[i]};
    toNearestRotations(alone);
    EXPECT_NEAR((alone[0] - together[i]).norm(), 0, 1e-9) << i;
  }
}

TEST(NearestRotations, areRotationsWhereManyAreAsGood) {
  posture::Rng rng(4);
  const Matrix3d q = randomRotation(rng);
  const std::vector<Matrix3d> given{Matrix3d::Zero(),
                                    -q,
                                    q * Vector3d(1, 0, 0).asDiagonal(),
                                    q * Vector3d(1, 1, -1).asDiagonal(),
                                    q * Vector3d(1, 1e-9, -1e-9).asDiagonal()};
  expectNearest(given, 1e-6);
}

}  // namespace
