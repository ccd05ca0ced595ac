// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace posture {

/// The rotation R with the largest trace of R' M (Kabsch 1976): one of those, where several are as
/// good; no numbers, where M is not finite.
Eigen::Matrix3d nearestRotation(const Eigen::Matrix3d& m);

}  // namespace posture
