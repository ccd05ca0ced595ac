// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "reduce_dimensions.h"

#include <posture/core/parallel.h>

#include <Eigen/Eigenvalues>

#include <algorithm>

namespace posture {

void reduceDimensions(Eigen::MatrixXf& a, Eigen::MatrixXf& b, int dimensions) {
  const auto d = a.cols();
  if (d <= dimensions) return;
  // As many rows as give a covariance of this size without chance directions.
  const Eigen::Index rows = std::min<Eigen::Index>(a.rows(), 4 * d), step = a.rows() / rows;
  Eigen::MatrixXf sample(rows, d);
  for (Eigen::Index i = 0; i < rows; ++i) sample.row(i) = a.row(i * step);
  sample.rowwise() -= sample.colwise().mean().eval();
  const Eigen::MatrixXf covariance = sample.transpose() * sample;
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXf> solver(covariance);
  const Eigen::MatrixXf leading = solver.eigenvectors().rightCols(dimensions);
  inParallel([&] { a = (a * leading).eval(); }, [&] { b = (b * leading).eval(); });
}

}  // namespace posture
