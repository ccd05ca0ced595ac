// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/types.h>

namespace posture {

/// The smooth map of space that takes `from` near to `to` and bends least (Dryden and Mardia 2002):
/// f(x) = a0 + A x - sum_i w_i |x - from_i|, minimising
/// sum |f(from_i) - to_i|^2 + smoothing * bending.
class ThinPlateSpline {
 public:
  /// Chooses the smoothing by generalised cross-validation (Craven and Wahba 1979).
  /// \param from, to  m x 3, same unit; m >= 1. With at most 4 points, 3 in a
  ///        plane, 2 on a line, the map is the affine (or constant) one of least squares.
  /// \throws std::invalid_argument  sizes differ, or no points.
  ThinPlateSpline(const Points& from, const Points& to);

  /// \param smoothing  >= 0, a length; 0 interpolates.
  ThinPlateSpline(const Points& from, const Points& to, double smoothing);

  Eigen::RowVector3d operator()(const Eigen::RowVector3d& x) const;

  double smoothing() const { return smoothing_; }

 private:
  void fit(const Points& to, const double* smoothing);

  Points centers_;                      // m x 3
  Points weights_;                      // m x 3, sum 0
  Eigen::Matrix<double, 4, 3> affine_;  // row 0: translation
  double smoothing_ = 0;
};

}  // namespace posture
