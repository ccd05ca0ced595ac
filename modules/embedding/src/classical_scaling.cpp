// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/error.h>
#include <posture/embedding/scaling.h>

#include <Spectra/MatOp/DenseSymMatProd.h>
#include <Spectra/SymEigsSolver.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace posture {

Points classicalScaling(const Matrix& distances) {
  const int s = static_cast<int>(distances.rows());
  require(s > 3 && distances.cols() == s, "classicalScaling: needs a square matrix of size > 3");
  Matrix gram = distances.array().square();
  const Eigen::RowVectorXd column_mean = gram.colwise().mean();
  const double mean = column_mean.mean();
  gram.rowwise() -= column_mean;
  gram.colwise() -= column_mean.transpose() - Vector::Constant(s, mean);
  gram *= -0.5;

  // The Krylov space Spectra recommends, within the size of the matrix.
  const int krylov = std::min(s, 20);
  Spectra::DenseSymMatProd<double> product(gram);
  Spectra::SymEigsSolver<Spectra::DenseSymMatProd<double>> solver(product, 3, krylov);
  solver.init();
  solver.compute(Spectra::SortRule::LargestAlge);
  if (solver.info() != Spectra::CompInfo::Successful)
    throw std::runtime_error("classicalScaling: no eigenvectors found");
  Points points(s, 3);
  for (int k = 0; k < 3; ++k)
    points.col(k) =
        solver.eigenvectors().col(k) * std::sqrt(std::max(0.0, solver.eigenvalues()[k]));
  return points;
}

}  // namespace posture
