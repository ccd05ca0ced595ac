// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace posture {

/// Sums of weighted points, and the plane that fits them best.
class LocalPlane {
 public:
  void add(const Eigen::Vector3d& point, double weight) {
    weight_ += weight;
    sum_ += weight * point;
    products_.noalias() += weight * point * point.transpose();
  }

  struct Fit {
    Eigen::Vector3d normal;  ///< unit, of any sign
    double residual;         ///< root mean square distance of the points to the plane
    double breadth;          ///< the same along the second widest direction
  };
  Fit fit() const;

 private:
  double weight_ = 0;
  Eigen::Vector3d sum_ = Eigen::Vector3d::Zero();
  Eigen::Matrix3d products_ = Eigen::Matrix3d::Zero();
};

}  // namespace posture
