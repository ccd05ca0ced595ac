// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/error.h>
#include <posture/core/rng.h>
#include <posture/spectral/spectral_basis.h>

#include <Eigen/SparseCholesky>
#include <Spectra/SymEigsSolver.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <vector>

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
      throw InputError("has a Laplacian that cannot be factorised");
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

/// The operator with what was found already taken to zero.
class Deflated {
 public:
  using Scalar = double;

  Deflated(const InverseOperator& inverse, const Matrix& found)
      : inverse_(inverse), found_(found) {}

  Eigen::Index rows() const { return inverse_.rows(); }
  Eigen::Index cols() const { return inverse_.cols(); }

  void perform_op(const double* in, double* out) const {
    const Vector x = rest(Eigen::Map<const Vector>(in, rows()));
    Vector y(rows());
    inverse_.perform_op(x.data(), y.data());
    Eigen::Map<Vector>(out, rows()) = rest(y);
  }

 private:
  Vector rest(const Vector& x) const { return x - found_ * (found_.transpose() * x); }

  const InverseOperator& inverse_;
  const Matrix& found_;
};

/// The largest eigenvalues of an operator, decreasing, and its orthonormal eigenvectors.
struct Pairs {
  Vector values;
  Matrix vectors;
};

/// \param round  how often it was asked for before: what one random vector misses of an eigenvalue
///        that is there several times, it would miss again.
template <class Operator>
Pairs largestPairs(const Operator& op, int count, int round) {
  // By Weyl's law the spectra of all surfaces fall off alike. With 2.4 times as many dimensions as
  // pairs these had converged on all of ten meshes, with twice as many on none: it began anew.
  const int n = static_cast<int>(op.rows());
  const int krylov = std::min(n, std::max(12 * count / 5, count + 20));
  Spectra::SymEigsSolver<Operator> solver(const_cast<Operator&>(op), count, krylov);
  // Not from the constant function: that is a solution, and rounding alone would lead on from
  // there, not always to an end.
  Rng rng(round);
  Vector start(n);
  for (double& x : start) x = rng.normal();
  bool has_converged = true;
  try {
    solver.init(start.data());
    solver.compute(Spectra::SortRule::LargestMagn, 300, 1e-9);
  } catch (const std::runtime_error&) {  // of the small problems within
    has_converged = false;
  }
  if (!has_converged || solver.info() != Spectra::CompInfo::Successful)
    throw InputError("has a Laplacian whose eigenvalues do not converge");
  return {solver.eigenvalues(), solver.eigenvectors()};
}

/// How many eigenvalues of the Laplacian lie below `bound`: as many as L - bound M has negative
/// pivots (Sylvester's law of inertia).
int countBelow(const Laplacian& laplacian, double bound) {
  Eigen::SparseMatrix<double> shifted = laplacian.stiffness;
  shifted.diagonal() -= bound * laplacian.mass;
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor(shifted);
  if (factor.info() != Eigen::Success) return 0;
  return static_cast<int>((factor.vectorD().array() < 0).count());
}

/// Takes in pairs that were missed; as many stay as there were.
void merge(const Pairs& missed, Pairs& pairs) {
  const auto count = pairs.values.size(), all = count + missed.values.size();
  Vector values(all);
  values << pairs.values, missed.values;
  Matrix vectors(pairs.vectors.rows(), all);
  vectors << pairs.vectors, missed.vectors;
  std::vector<Eigen::Index> order(all);
  std::iota(order.begin(), order.end(), Eigen::Index{0});
  std::stable_sort(order.begin(), order.end(), [&](Eigen::Index i, Eigen::Index j) {
    return values[i] > values[j];
  });
  for (Eigen::Index k = 0; k < count; ++k) {
    pairs.values[k] = values[order[k]];
    pairs.vectors.col(k) = vectors.col(order[k]);
  }
}

}  // namespace

SpectralBasis spectralBasis(const Laplacian& laplacian, int count) {
  const int n = static_cast<int>(laplacian.mass.size());
  require(n > 2 && count > 0, "spectralBasis: at least three vertices and one function");
  count = std::min(count, n - 2);
  // By Weyl's law the k-th eigenvalue is near 4 pi k / area; a shift of the first one's size keeps
  // the matrix definite and costs no convergence.
  const double shift = 4 * M_PI / laplacian.mass.sum();
  const InverseOperator inverse(laplacian, shift);
  Pairs pairs = largestPairs(inverse, count, 0);
  // A Krylov space holds one function of each eigenvalue. Where a symmetry of the mesh gives it
  // several, rounding brings in the others, sometimes too late.
  for (int round = 1;; ++round) {
    const double last = (1 + 1e-6) * pairs.values[count - 1];
    const double bound = shift / last - shift;
    const int found = static_cast<int>((pairs.values.array() > last).count());
    const int missing = bound > 0 ? countBelow(laplacian, bound) - found : 0;
    if (missing <= 0) break;
    const Pairs missed =
        largestPairs(Deflated(inverse, pairs.vectors), std::min(missing, n - 2), round);
    if (missed.values[0] <= last) break;
    merge(missed, pairs);
  }
  SpectralBasis basis;
  basis.eigenvalues = (shift * pairs.values.cwiseInverse().array() - shift).max(0.0);
  basis.functions = inverse.rootMass().cwiseInverse().asDiagonal() * pairs.vectors;
  return basis;
}

}  // namespace posture
