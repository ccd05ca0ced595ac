// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "points/local_plane.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace posture {

LocalPlane::Fit LocalPlane::fit() const {
  const Eigen::Vector3d mean = sum_ / weight_;
  Eigen::Matrix3d covariance = products_ / weight_ - mean * mean.transpose();
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(covariance);
  return {solver.eigenvectors().col(0),
          std::sqrt(std::max(0.0, solver.eigenvalues()[0])),
          std::sqrt(std::max(0.0, solver.eigenvalues()[1]))};
}

}  // namespace posture
