// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

namespace posture {

/// Sums over pairs of places, from which the best rigid motion and its misfit follow without going
/// through the places again.
class Moments {
 public:
  void add(const Eigen::Vector3d& rest, const Eigen::Vector3d& posed, double weight);
  void add(const Moments& other);

  double misfit() const;  ///< weighted sum of squared distances under the best rigid motion
  Eigen::Isometry3d motion() const;  ///< Kabsch 1976

 private:
  Eigen::Matrix3d covariance() const;

  double weight_ = 0;
  Eigen::Vector3d rest_ = Eigen::Vector3d::Zero(), posed_ = Eigen::Vector3d::Zero();
  double rest_squared_ = 0, posed_squared_ = 0;
  Eigen::Matrix3d product_ = Eigen::Matrix3d::Zero();
};

}  // namespace posture
