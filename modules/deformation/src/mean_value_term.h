// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/deformation/mean_value_encoding.h>

#include <ceres/cost_function.h>

namespace posture {

/// factor times the residual of one vertex; parameters: its place, then those of its corners.
class MeanValueTerm : public ceres::CostFunction {
 public:
  MeanValueTerm(const MeanValueEncoding& encoding, int vertex, double factor);

  bool Evaluate(double const* const* parameters,
                double* residuals,
                double** jacobians) const override;

  /// Where its parameters are in n x 3 places.
  std::vector<double*> parametersIn(Points& places) const;

 private:
  const MeanValueEncoding& encoding_;
  int vertex_;
  double factor_;
};

}  // namespace posture
