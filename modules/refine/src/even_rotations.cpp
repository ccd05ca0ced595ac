// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "even_rotations.h"

#include <Eigen/Geometry>

#include <cmath>

namespace posture {

std::vector<Eigen::Matrix3d> evenRotations(int count) {
  constexpr double PHI = 1.414213562373095, PSI = 1.533751168755204;
  std::vector<Eigen::Matrix3d> rotations;
  for (int i = 0; i < count; ++i) {
    const double s = i + 0.5, r = std::sqrt(s / count), rest = std::sqrt(1 - s / count);
    const double alpha = 2 * M_PI * s / PHI, beta = 2 * M_PI * s / PSI;
    const Eigen::Quaterniond q(
        r * std::sin(alpha), r * std::cos(alpha), rest * std::sin(beta), rest * std::cos(beta));
    rotations.push_back(q.normalized().toRotationMatrix());
  }
  return rotations;
}

}  // namespace posture
