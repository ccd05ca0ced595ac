// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/error.h>
#include <posture/dense/thin_plate_spline.h>

#include <Eigen/Eigenvalues>
#include <Eigen/QR>

#include <cmath>
#include <limits>

namespace posture {
namespace {

/// The smoothing with the least GCV score m |(I - A) y|^2 / tr(I - A)^2, where in the eigenbasis
/// I - A = diag(smoothing / (eigenvalue + smoothing)).
/// \param data_sq  squared coordinates of the data in that basis, summed over the dimensions.
double crossValidated(const Vector& eigenvalues, const Vector& data_sq) {
  const double largest = eigenvalues.maxCoeff();
  double best_score = std::numeric_limits<double>::infinity(), best = largest;
  // Half an octave apart: the score is flat about its minimum.
  for (double smoothing = largest * 1e-10; smoothing <= largest; smoothing *= std::sqrt(2.0)) {
    const Eigen::ArrayXd shrink = smoothing / (eigenvalues.array() + smoothing);
    const double score = (shrink.square() * data_sq.array()).sum() / std::pow(shrink.sum(), 2);
    if (score < best_score) {
      best_score = score;
      best = smoothing;
    }
  }
  return best;
}

}  // namespace

ThinPlateSpline::ThinPlateSpline(const Points& from, const Points& to) : centers_(from) {
  fit(to, nullptr);
}

ThinPlateSpline::ThinPlateSpline(const Points& from, const Points& to, double smoothing)
    : centers_(from) {
  require(smoothing >= 0, "ThinPlateSpline: negative smoothing");
  fit(to, &smoothing);
}

void ThinPlateSpline::fit(const Points& to, const double* smoothing) {
  const int m = static_cast<int>(centers_.rows());
  require(m > 0 && to.rows() == m, "ThinPlateSpline: needs as many places as points, at least one");
  Matrix affine_basis(m, 4);
  affine_basis << Vector::Ones(m), centers_;
  const Eigen::ColPivHouseholderQR<Matrix> qr(affine_basis);
  weights_ = Points::Zero(m, 3);
  const int rank = static_cast<int>(qr.rank());
  if (m > rank) {
    // In the space orthogonal to affine maps the kernel -|x - y| is positive definite.
    Matrix kernel(m, m);
    for (int i = 0; i < m; ++i)
      kernel.col(i) = -(centers_.rowwise() - centers_.row(i)).rowwise().norm();
    const auto q = qr.householderQ();
    kernel.applyOnTheLeft(q.adjoint());
    kernel.applyOnTheRight(q);
    Matrix data = to;
    data.applyOnTheLeft(q.adjoint());
    const int rest = m - rank;
    const Eigen::SelfAdjointEigenSolver<Matrix> eigen(kernel.bottomRightCorner(rest, rest));
    const Vector eigenvalues = eigen.eigenvalues().cwiseMax(0.0);
    const double floor = std::numeric_limits<double>::epsilon() * eigenvalues.maxCoeff();
    if (smoothing != nullptr) smoothing_ = *smoothing;
    if (floor > 0) {  // else all points are at one place
      const Matrix coordinates = eigen.eigenvectors().transpose() * data.bottomRows(rest);
      if (smoothing == nullptr)
        smoothing_ = crossValidated(eigenvalues, coordinates.rowwise().squaredNorm());
      const Vector inverse = (eigenvalues.array() + smoothing_).cwiseMax(floor).inverse();
      Matrix weights = Matrix::Zero(m, 3);
      weights.bottomRows(rest) = eigen.eigenvectors() * (inverse.asDiagonal() * coordinates);
      weights.applyOnTheLeft(q);
      weights_ = weights;
    }
  }
  // What the kernel part and the smoothing leave is affine.
  Matrix left = to - smoothing_ * weights_;
  for (int i = 0; i < m; ++i)
    left.row(i) += (centers_.rowwise() - centers_.row(i)).rowwise().norm().transpose() * weights_;
  affine_ = qr.solve(left);
}

Eigen::RowVector3d ThinPlateSpline::operator()(const Eigen::RowVector3d& x) const {
  Eigen::RowVector3d y = affine_.row(0) + x * affine_.bottomRows<3>();
  for (int i = 0; i < centers_.rows(); ++i) y -= (x - centers_.row(i)).norm() * weights_.row(i);
  return y;
}

}  // namespace posture
