// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/mesh/nearest_rotation.h>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <limits>

namespace posture {
namespace {

using Eigen::Matrix3d;

const Matrix3d TURN =
    Eigen::AngleAxisd(2, Eigen::Vector3d(1, -2, 0.5).normalized()).toRotationMatrix();

TEST(NearestRotation, isThatOfAMatrixThatStretchesToo) {
  Matrix3d stretch;
  stretch << 3, 0.4, 0, 0.4, 2, 0.1, 0, 0.1, 0.5;
  EXPECT_TRUE(nearestRotation(TURN * stretch).isApprox(TURN, 1e-12));
}

TEST(NearestRotation, doesNotMirror) {
  const Matrix3d mirrored = TURN * Eigen::Vector3d(3, 2, -0.5).asDiagonal();
  const Matrix3d rotation = nearestRotation(mirrored);
  EXPECT_NEAR(rotation.determinant(), 1, 1e-12);
  EXPECT_TRUE(rotation.isApprox(TURN, 1e-12));  // least is lost along the shortest axis
}

TEST(NearestRotation, ofWhatIsFlatOrNothingIsARotation) {
  const Matrix3d flat = TURN * Eigen::Vector3d(3, 2, 0).asDiagonal();
  EXPECT_TRUE(nearestRotation(flat).isApprox(TURN, 1e-12));
  EXPECT_NEAR(nearestRotation(Matrix3d::Zero()).determinant(), 1, 1e-12);
}

TEST(NearestRotation, ofNoNumbersIsNone) {
  Matrix3d m = TURN;
  m(1, 2) = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(nearestRotation(m).array().isNaN().all());
}

}  // namespace
}  // namespace posture
