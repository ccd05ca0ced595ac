// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "moments.h"

#include <posture/mesh/nearest_rotation.h>

#include <Eigen/SVD>

#include <algorithm>

namespace posture {

using Eigen::Matrix3d;
using Eigen::Vector3d;

void Moments::add(const Vector3d& rest, const Vector3d& posed, double weight) {
  weight_ += weight;
  rest_ += weight * rest;
  posed_ += weight * posed;
  rest_squared_ += weight * rest.squaredNorm();
  posed_squared_ += weight * posed.squaredNorm();
  product_ += weight * posed * rest.transpose();
}

void Moments::add(const Moments& other) {
  weight_ += other.weight_;
  rest_ += other.rest_;
  posed_ += other.posed_;
  rest_squared_ += other.rest_squared_;
  posed_squared_ += other.posed_squared_;
  product_ += other.product_;
}

Matrix3d Moments::covariance() const { return product_ - posed_ * rest_.transpose() / weight_; }

double Moments::misfit() const {
  const Matrix3d m = covariance();
  const Vector3d s = Eigen::JacobiSVD<Matrix3d>(m).singularValues();
  const double aligned = s[0] + s[1] + (m.determinant() < 0 ? -s[2] : s[2]);
  const double rest_spread = rest_squared_ - rest_.squaredNorm() / weight_,
               posed_spread = posed_squared_ - posed_.squaredNorm() / weight_;
  return std::max(0.0, rest_spread + posed_spread - 2 * aligned);
}

Eigen::Isometry3d Moments::motion() const {
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
  motion.linear() = nearestRotation(covariance());
  motion.translation() = (posed_ - motion.linear() * rest_) / weight_;
  return motion;
}

}  // namespace posture
