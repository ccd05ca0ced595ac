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

void Mass::add(const Vector3d& place, double area) {
  area_ += area;
  first_ += area * place;
  second_ += area * place * place.transpose();
}

void Mass::add(const Mass& other) {
  area_ += other.area_;
  first_ += other.first_;
  second_ += other.second_;
}

Matrix3d Mass::inertia() const {
  const Matrix3d spread = second_ - first_ * first_.transpose() / area_;
  return spread.trace() * Matrix3d::Identity() - spread;
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

double turnOf(const Mass& a, const Mass& b, const Vector3d& joint, double cost) {
  // b turns by u about the joint, both by w, and shift as fits best: what is left is
  //   w' Ja w + (u - w)' Jb (u - w) + m |u x (cb - joint) - w x (cb - ca)|^2,  1/m = 1/ma + 1/mb,
  // least over w a quadratic form of u.
  const Matrix3d arm = crossing(b.centroid() - joint),
                 apart = crossing(b.centroid() - a.centroid()), own = b.inertia();
  const double m = a.area() * b.area() / (a.area() + b.area());
  const Matrix3d of_both = a.inertia() + own + m * apart.transpose() * apart;
  const Matrix3d mixed = own + m * apart.transpose() * arm;
  const Matrix3d of_turn =
      own + m * arm.transpose() * arm - mixed.transpose() * of_both.ldlt().solve(mixed);
  const double most = Eigen::SelfAdjointEigenSolver<Matrix3d>(0.5 * (of_turn + of_turn.transpose()),
                                                              Eigen::EigenvaluesOnly)
                          .eigenvalues()[2];
  return most > 0 ? std::sqrt(cost / most) : 0;
}

}  // namespace posture
