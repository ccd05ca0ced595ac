// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <vector>

namespace posture {

/// Rotations spread evenly (super-Fibonacci spirals, Alexa 2022).
std::vector<Eigen::Matrix3d> evenRotations(int count);

}  // namespace posture
