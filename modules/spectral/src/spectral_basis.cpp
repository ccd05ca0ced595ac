// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/error.h>
#include <posture/core/rng.h>
#include <posture/spectral/spectral_basis.h>

#include <Eigen/SparseCholesky>
#include <Spectra/SymEigsSolver.h>

#include <algorithm>
#include <stdexcept>

namespace posture {
namespace {

/// x -> shift M^(1/2) (L + shift M)^(-1) M^(1/2) x: its largest eigenvalues are the Laplacian's
/// least. They lie in (0, 1] in any unit, as the solver's thresholds ask for.
class InverseOperator {
 public:
  using Scalar = double;

  InverseOperator(const Laplacian& laplacian, double shift)
      : root_mass_(laplacian.mass.cwiseSqrt()), shift_(shift) {
    Eigen::SparseMatrix<double> shifted = laplacian.stiffness;
    shifted.diagonal() += shift * laplacian.mass;
    factor_.compute(shifted);
    if (factor_.info() != Eigen::Success)
      throw std::runtime_error("spectralBasis: the Laplacian cannot be factorised");
  }

  Eigen::Index rows() const { return root_mass_.size(); }
  Eigen::Index cols() const { return root_mass_.size(); }

  void perform_op(const double* in, double* out) const {
    const Eigen::Map<const Vector> x(in, rows());
    Eigen::Map<Vector>(out, rows()) =
        shift_ * root_mass_.cwiseProduct(factor_.solve(root_mass_.cwiseProduct(x)));
  }

  const Vector& rootMass() const { return root_mass_; }

 private:
  Vector root_mass_;
  double shift_;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor_;
};

}  // namespace

SpectralBasis spectralBasis(const Laplacian& laplacian, int count) {
  const int n = static_cast<int>(laplacian.mass.size());
  require(n > 2 && count > 0, "spectralBasis: at least three vertices and one function");
  count = std::min(count, n - 2);
  // By Weyl's law the k-th eigenvalue is near 4 pi k / area; a shift of the first one's size keeps
  // the matrix definite and costs no convergence.
  const double shift = 12.566370614359172 / laplacian.mass.sum();
  const InverseOperator inverse(laplacian, shift);
  const int krylov = std::min(n, std::max(2 * count, count + 20));
  Spectra::SymEigsSolver<InverseOperator> solver(
      const_cast<InverseOperator&>(inverse), count, krylov);
  // Not from the constant function: that is a solution, and rounding alone would lead on from
  // there, not always to an end.
  Rng rng(0);
  Vector start(n);
  for (double& x : start) x = rng.normal();
  solver.init(start.data());
  solver.compute(Spectra::SortRule::LargestMagn, 300, 1e-9);
  if (solver.info() != Spectra::CompInfo::Successful)
    throw std::runtime_error("spectralBasis: the eigenvalues do not converge");
  SpectralBasis basis;
  basis.eigenvalues = (shift * solver.eigenvalues().cwiseInverse().array() - shift).max(0.0);
  basis.functions = inverse.rootMass().cwiseInverse().asDiagonal() * solver.eigenvectors();
  return basis;
}

}  // namespace posture
