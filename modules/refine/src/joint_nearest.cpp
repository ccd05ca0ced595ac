// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "joint_nearest.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <limits>

namespace posture {

void nearestBothWays(const Eigen::Ref<const Eigen::MatrixXf>& a,
                     const Eigen::Ref<const Eigen::MatrixXf>& b,
                     std::vector<int>& forward,
                     std::vector<int>& backward) {
  // One block of products serves both directions and stays in the cache.
  constexpr Eigen::Index BLOCK = 64;
  const Eigen::VectorXf half_a = 0.5f * a.rowwise().squaredNorm(),
                        half_b = 0.5f * b.rowwise().squaredNorm();
  const auto na = a.rows(), nb = b.rows();
  forward.assign(na, 0);
  backward.assign(nb, 0);
  Eigen::VectorXf best_a = Eigen::VectorXf::Constant(na, std::numeric_limits<float>::infinity());
  Eigen::MatrixXf products;
  for (Eigen::Index first = 0; first < nb; first += BLOCK) {
    const Eigen::Index width = std::min(BLOCK, nb - first);
    products.noalias() = a * b.middleRows(first, width).transpose();
    for (Eigen::Index j = 0; j < width; ++j) {
      const float offset = half_b[first + j];
      Eigen::Index nearest = 0;
      (half_a - products.col(j)).minCoeff(&nearest);
      backward[first + j] = static_cast<int>(nearest);
      for (Eigen::Index i = 0; i < na; ++i) {
        const float d = offset - products(i, j);
        if (d < best_a[i]) {
          best_a[i] = d;
          forward[i] = static_cast<int>(first + j);
        }
      }
    }
  }
}

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
  a = (a * leading).eval();
  b = (b * leading).eval();
}

}  // namespace posture
