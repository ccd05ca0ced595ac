// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/error.h>
#include <posture/embedding/scaling.h>

#include <Eigen/Eigenvalues>
#include <Spectra/MatOp/DenseSymMatProd.h>
#include <Spectra/SymEigsSolver.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace posture {
namespace {

constexpr int AXES = 3;

struct LeadingPairs {
  Vector values;   ///< the largest, decreasing
  Matrix vectors;  ///< orthonormal
};

/// By the Krylov space Spectra recommends, within the size of the matrix; false where that does not
/// converge, as with eigenvalues that are many times the same.
bool findByLanczos(const Matrix& gram, LeadingPairs& leading) {
  const int krylov = std::min(static_cast<int>(gram.rows()), 20);
  Spectra::DenseSymMatProd<double> product(gram);
  Spectra::SymEigsSolver<Spectra::DenseSymMatProd<double>> solver(product, AXES, krylov);
  try {
    solver.init();
    solver.compute(Spectra::SortRule::LargestAlge);
  } catch (const std::runtime_error&) {  // of the small problems within
    return false;
  }
  if (solver.info() != Spectra::CompInfo::Successful) return false;
  leading = {solver.eigenvalues(), solver.eigenvectors()};
  return true;
}

LeadingPairs leadingPairs(const Matrix& gram) {
  LeadingPairs leading;
  if (findByLanczos(gram, leading)) return leading;
  const Eigen::SelfAdjointEigenSolver<Matrix> all(gram);
  return {all.eigenvalues().tail<AXES>().reverse(),
          all.eigenvectors().rightCols<AXES>().rowwise().reverse()};
}

}  // namespace

Points classicalScaling(const Matrix& distances) {
  const int s = static_cast<int>(distances.rows());
  require(s > 3 && distances.cols() == s, "classicalScaling: needs a square matrix of size > 3");
  Matrix gram = distances.array().square();
  const Eigen::RowVectorXd column_mean = gram.colwise().mean();
  const double mean = column_mean.mean();
  gram.rowwise() -= column_mean;
  gram.colwise() -= column_mean.transpose() - Vector::Constant(s, mean);
  gram *= -0.5;

  const LeadingPairs leading = leadingPairs(gram);
  Points points(s, AXES);
  for (int k = 0; k < AXES; ++k)
    points.col(k) = leading.vectors.col(k) * std::sqrt(std::max(0.0, leading.values[k]));
  return points;
}

}  // namespace posture
