// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <ceres/sized_cost_function.h>

#include <utility>

namespace posture {

/// factor times (|p - q|^2 / length^2 - 1) / 2: the relative change of an edge's length, where
/// small.
class EdgeTerm : public ceres::SizedCostFunction<1, 3, 3> {
 public:
  EdgeTerm(double length, double factor) : length_sq_(length * length), factor_(factor) {}

  bool Evaluate(double const* const* parameters,
                double* residuals,
                double** jacobians) const override;

 private:
  double length_sq_, factor_;
};

/// factor times the part of p - place along a unit direction.
class PlaneTerm : public ceres::SizedCostFunction<1, 3> {
 public:
  PlaneTerm(Eigen::Vector3d place, const Eigen::Vector3d& direction, double factor)
      : place_(std::move(place)), direction_(factor * direction) {}

  bool Evaluate(double const* const* parameters,
                double* residuals,
                double** jacobians) const override;

 private:
  Eigen::Vector3d place_, direction_;
};

/// factor times (p - place).
class PlaceTerm : public ceres::SizedCostFunction<3, 3> {
 public:
  PlaceTerm(Eigen::Vector3d place, double factor) : place_(std::move(place)), factor_(factor) {}

  bool Evaluate(double const* const* parameters,
                double* residuals,
                double** jacobians) const override;

 private:
  Eigen::Vector3d place_;
  double factor_;
};

}  // namespace posture
