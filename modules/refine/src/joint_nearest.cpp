// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "joint_nearest.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <limits>

namespace posture {
namespace {

/// Takes row j of b where it is nearer than what each row of a has. Without branches: vectorized.
void keepLess(
    const float* products, float offset, int j, Eigen::VectorXf& best, std::vector<int>& nearest) {
  float* const least = best.data();
  int* const index = nearest.data();
  for (Eigen::Index i = 0; i < best.size(); ++i) {
    const float d = offset - products[i];
    const bool less = d < least[i];
    index[i] = less ? j : index[i];
    least[i] = less ? d : least[i];
  }
}

}  // namespace

void nearestBothWays(const Eigen::Ref<const Eigen::MatrixXf>& a,
                     const Eigen::Ref<const Eigen::MatrixXf>& b,
                     std::vector<int>& forward,
                     std::vector<int>& backward) {
  // One block of products serves both directions and stays in the cache.
  constexpr Eigen::Index BLOCK = 64;
  constexpr float FAR = std::numeric_limits<float>::infinity();
  const auto na = a.rows(), nb = b.rows();
  Eigen::MatrixXf numbers = a;
  Eigen::VectorXf half_a = 0.5f * a.rowwise().squaredNorm();
  const Eigen::VectorXf half_b = 0.5f * b.rowwise().squaredNorm();
  // What is no number is nobody's nearest. Taken out here: a minimum of what may hold some is not
  // defined, or takes longer.
  for (Eigen::Index i = 0; i < na; ++i)
    if (!std::isfinite(half_a[i])) {
      numbers.row(i).setZero();
      half_a[i] = FAR;
    }
  forward.assign(na, 0);
  backward.assign(nb, 0);
  Eigen::VectorXf best_a = Eigen::VectorXf::Constant(na, FAR);
  Eigen::MatrixXf products;
  Eigen::VectorXf distance(na);
  for (Eigen::Index first = 0; first < nb; first += BLOCK) {
    const Eigen::Index width = std::min(BLOCK, nb - first);
    products.noalias() = numbers * b.middleRows(first, width).transpose();
    for (Eigen::Index j = 0; j < width; ++j) {
      const int row_b = static_cast<int>(first + j);
      distance = half_a - products.col(j);
      const float* const nearest =
          std::find(distance.data(), distance.data() + na, distance.minCoeff());
      // A row of b that is no number finds none.
      backward[row_b] = static_cast<int>(std::min(nearest - distance.data(), na - 1));
      keepLess(products.col(j).data(), half_b[row_b], row_b, best_a, forward);
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
