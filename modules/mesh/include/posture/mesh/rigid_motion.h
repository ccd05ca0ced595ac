// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/types.h>

#include <Eigen/Geometry>

namespace posture {

/// The rigid motion that takes points nearest to others, by least squares (Umeyama 1991, without
/// the scale). Fewer than three tell no turn: they are only moved; none at all stay.
/// \pre  as many of the one as of the other.
Eigen::Isometry3d rigidMotion(const Points& from, const Points& to);

/// Points after a motion.
Points moved(const Eigen::Isometry3d& motion, const Points& points);

}  // namespace posture
