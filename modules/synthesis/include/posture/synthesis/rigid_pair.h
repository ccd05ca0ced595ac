// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/synthesis/articulated_body.h>

#include <Eigen/Geometry>

namespace posture {

/// A body that holds still, scanned twice.
struct RigidPair {
  ArticulatedBody source, target;
  Eigen::Isometry3d T_target_source;
};

/// The body in one pose, meshed and disturbed twice; each lacks a fifth of its length, at the other
/// end of its longest axis, and the source is moved a little: by 6 degrees and 4 % of the length.
/// \throws std::invalid_argument  as makeBody.
RigidPair makeRigidPair(const BodyOptions& options);

}  // namespace posture
