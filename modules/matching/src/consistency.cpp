// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/error.h>
#include <posture/matching/consistency.h>

#include <Spectra/MatOp/DenseSymMatProd.h>
#include <Spectra/SymEigsSolver.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace posture {
namespace {

/// The eigenvector of the largest eigenvalue, entries >= 0 (Perron and Frobenius).
Vector principalEigenvector(const Matrix& matrix) {
  const int m = static_cast<int>(matrix.rows());
  if (m < 3) return Vector::Ones(m);
  Spectra::DenseSymMatProd<double> product(matrix);
  Spectra::SymEigsSolver<Spectra::DenseSymMatProd<double>> solver(product, 1, std::min(m, 20));
  try {
    solver.init();
    solver.compute(Spectra::SortRule::LargestAlge);
    if (solver.info() == Spectra::CompInfo::Successful)
      return solver.eigenvectors().col(0).cwiseAbs();
  } catch (const std::runtime_error&) {  // the solver's, of the small problems within
  }
  // Without a gap below the largest eigenvalue the row sums rank as well as any vector.
  return matrix.rowwise().sum();
}

}  // namespace

double lengthConsistency(double a, double b) {
  const double ratio = a < b ? a / b : b / a;
  return std::isfinite(ratio) ? ratio : 0;
}

Matrix consistencyMatrix(const std::vector<Match>& matches,
                         const Matrix& source_distances,
                         const Matrix& target_distances) {
  const int m = static_cast<int>(matches.size());
  Matrix consistency = Matrix::Ones(m, m);
  for (int i = 0; i < m; ++i)
    for (int j = 0; j < i; ++j)
      consistency(i, j) = consistency(j, i) =
          lengthConsistency(source_distances(matches[i].source, matches[j].source),
                            target_distances(matches[i].target, matches[j].target));
  return consistency;
}

double consistencyThreshold(const std::vector<Matrix>& matrices) {
  double sum = 0, count = 0;
  for (const Matrix& c : matrices) {
    sum += (1 - c.array()).square().sum();
    count += static_cast<double>(c.size() - c.rows());
  }
  const double sigma = count > 0 ? std::sqrt(sum / count) : 0;
  // A perfect isometry leaves no deviation to learn; its lengths still differ by rounding.
  return std::clamp(1 - 3 * sigma, 0.0, 1 - 1e-6);
}

std::vector<int> consistencyKernel(const Matrix& consistency, double threshold) {
  require(threshold < 1, "consistencyKernel: the threshold must be below 1");
  const int m = static_cast<int>(consistency.rows());
  Matrix affinity = (((consistency.array() - threshold) / (1 - threshold)).cwiseMax(0.0)).square();
  affinity.diagonal().setZero();
  const Vector strength = principalEigenvector(affinity);
  std::vector<int> by_strength(m);
  std::iota(by_strength.begin(), by_strength.end(), 0);
  std::stable_sort(by_strength.begin(), by_strength.end(), [&](int a, int b) {
    return strength[a] > strength[b];
  });
  std::vector<char> dropped(m, 0);
  std::vector<int> kernel;
  for (int i : by_strength) {
    if (dropped[i] || !(strength[i] > 0)) continue;
    kernel.push_back(i);
    for (int j = 0; j < m; ++j)
      if (j != i && consistency(i, j) <= threshold) dropped[j] = 1;
  }
  std::sort(kernel.begin(), kernel.end());
  return kernel;
}

}  // namespace posture
