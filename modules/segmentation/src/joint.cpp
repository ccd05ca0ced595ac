// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "joint.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace posture {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// m * x = v x x.
Matrix3d crossing(const Vector3d& v) {
  Matrix3d m;
  m << 0, -v[2], v[1], v[2], 0, -v[0], -v[1], v[0], 0;
  return m;
}

}  // namespace

void Stiffness::add(const Vector3d& place, const Vector3d& normal, double area) {
  Eigen::Matrix<double, 3, 6> moved;
  moved << -crossing(place), Matrix3d::Identity();
  const Vector6 off = moved.transpose() * normal;
  across_ += area * off * off.transpose();
  whole_ += area * moved.transpose() * moved;
}

void Stiffness::add(const Stiffness& other) {
  across_ += other.across_;
  whole_ += other.whole_;
}

Matrix6 Stiffness::about(const Vector3d& place, double along) const {
  Matrix6 from_origin = Matrix6::Identity();
  from_origin.bottomLeftCorner<3, 3>() = crossing(place);
  return from_origin.transpose() * (along * whole_ + (1 - along) * across_) * from_origin;
}

void Border::add(const Vector3d& from, const Vector3d& to) {
  constexpr double LEAST = 1e-12;  // an edge without length is a border too
  const double length = std::max((to - from).norm(), LEAST);
  length_ += length;
  sum_ += 0.5 * length * (from + to);
}

void Border::add(const Border& other) {
  length_ += other.length_;
  sum_ += other.sum_;
}

Joint::Joint(const Vector3d& place, const Matrix6& a, const Matrix6& b) : place_(place) {
  // Where b is off by x against a, a gives way by y and b by x - y: the least of y' a y +
  // (x - y)' b (x - y) is that of two springs in a row.
  constexpr double STILL = 1e-12;  // against motions that cost neither anything
  Matrix6 both = a + b;
  both.diagonal() *= 1 + STILL;
  const Matrix6 between = a * both.ldlt().solve(b);
  between_ = 0.5 * (between + between.transpose());
}

double Joint::cost(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b) const {
  const Eigen::Isometry3d apart = a.inverse() * b;
  const Eigen::AngleAxisd turn(apart.linear());
  Vector6 x;
  x << turn.angle() * turn.axis(), apart * place_ - place_;
  return std::max(0.0, x.dot(between_ * x));
}

double Joint::turn(double cost) const {
  const double most = Eigen::SelfAdjointEigenSolver<Matrix3d>(between_.topLeftCorner<3, 3>(),
                                                              Eigen::EigenvaluesOnly)
                          .eigenvalues()[2];
  return most > 0 ? std::sqrt(std::max(0.0, cost) / most) : 0;
}

}  // namespace posture
