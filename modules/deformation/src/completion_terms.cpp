// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "completion_terms.h"

namespace posture {

using Row = Eigen::RowVector3d;
using Column = Eigen::Vector3d;

bool EdgeTerm::Evaluate(double const* const* parameters,
                        double* residuals,
                        double** jacobians) const {
  const Column between =
      Eigen::Map<const Column>(parameters[0]) - Eigen::Map<const Column>(parameters[1]);
  residuals[0] = factor_ * 0.5 * (between.squaredNorm() / length_sq_ - 1);
  if (jacobians == nullptr) return true;
  for (int end = 0; end < 2; ++end) {
    if (jacobians[end] == nullptr) continue;
    Eigen::Map<Row> jacobian(jacobians[end]);
    jacobian = (end == 0 ? factor_ : -factor_) / length_sq_ * between.transpose();
  }
  return true;
}

bool PlaneTerm::Evaluate(double const* const* parameters,
                         double* residuals,
                         double** jacobians) const {
  residuals[0] = direction_.dot(Eigen::Map<const Column>(parameters[0]) - place_);
  if (jacobians == nullptr || jacobians[0] == nullptr) return true;
  Eigen::Map<Row> jacobian(jacobians[0]);
  jacobian = direction_.transpose();
  return true;
}

bool PlaceTerm::Evaluate(double const* const* parameters,
                         double* residuals,
                         double** jacobians) const {
  Eigen::Map<Column> off(residuals);
  off = factor_ * (Eigen::Map<const Column>(parameters[0]) - place_);
  if (jacobians == nullptr || jacobians[0] == nullptr) return true;
  Eigen::Map<Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> jacobian(jacobians[0]);
  jacobian = factor_ * Eigen::Matrix3d::Identity();
  return true;
}

}  // namespace posture
