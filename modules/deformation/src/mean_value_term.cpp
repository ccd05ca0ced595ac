// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "mean_value_term.h"

namespace posture {

using Matrix3RowMajor = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

MeanValueTerm::MeanValueTerm(const MeanValueEncoding& encoding, int vertex, double factor)
    : encoding_(encoding), vertex_(vertex), factor_(factor) {
  set_num_residuals(3);
  mutable_parameter_block_sizes()->assign(1 + encoding.first[vertex + 1] - encoding.first[vertex],
                                          3);
}

bool MeanValueTerm::Evaluate(double const* const* parameters,
                             double* residuals,
                             double** jacobians) const {
  const std::size_t count = parameter_block_sizes().size() - 1;
  std::vector<Eigen::Vector3d> corners(count);
  for (std::size_t k = 0; k < count; ++k)
    corners[k] = Eigen::Map<const Eigen::Vector3d>(parameters[k + 1]);
  const MeanValueResidual residual =
      meanValueResidual(encoding_,
                        vertex_,
                        Eigen::Map<const Eigen::Vector3d>(parameters[0]),
                        corners,
                        jacobians != nullptr);
  Eigen::Map<Eigen::Vector3d> value(residuals);
  value = factor_ * residual.value;
  if (jacobians == nullptr) return true;
  for (std::size_t k = 0; k <= count; ++k) {
    if (jacobians[k] == nullptr) continue;
    Eigen::Map<Matrix3RowMajor> jacobian(jacobians[k]);
    if (k == 0)
      jacobian = factor_ * Matrix3RowMajor::Identity();
    else
      jacobian = factor_ * residual.by_corner[k - 1];
  }
  return true;
}

std::vector<double*> MeanValueTerm::parametersIn(Points& places) const {
  std::vector<double*> parameters{places.row(vertex_).data()};
  for (int i = encoding_.first[vertex_]; i < encoding_.first[vertex_ + 1]; ++i)
    parameters.push_back(places.row(encoding_.corner[i]).data());
  return parameters;
}

}  // namespace posture
