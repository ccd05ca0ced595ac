// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "working_frame.h"
#include <cstdint>

namespace posture {

/// What PCL found, in the working frame.
struct Alignment {
  Eigen::Matrix4d motion = Eigen::Matrix4d::Identity();
  bool converged = false;
};

/// Size of the target in the working frame of all methods but NDT: PCL's defaults are lengths in
/// metres, and its examples are objects and scenes of about a metre.
constexpr double OBJECT_SIZE = 1;

/// The same for NDT, whose tutorial has a room and cells of 1 m: a twentieth of the target here.
constexpr double ROOM_SIZE = 20;

/// Correspondences farther apart do not count in the last pass: 5 cm in the documentation of
/// pcl::IterativeClosestPoint.
constexpr double FINE_DISTANCE = 0.05;

/// At most so many iterations a pass, PCL's own bound for GICP; its example for ICP has 50, after
/// which large turns are not done. The epsilon is that of the example, a squared length.
constexpr int ICP_ITERATIONS = 200;
constexpr double ICP_EPSILON = 1e-8;

/// Leaf of the voxel filter before features. It leaves about a thousand points of a body; the
/// tutorial's object keeps three times as many, which would take ten times as long.
constexpr double FEATURE_LEAF = 0.02;

Alignment icp(const LocalCloud& source, const LocalCloud& target);
/// The last pass alone, from `start`.
Alignment fineIcp(const LocalCloud& source, const LocalCloud& target, const Eigen::Matrix4d& start);
Alignment icpPointToPlane(const LocalCloud& source, const LocalCloud& target);
Alignment gicp(const LocalCloud& source, const LocalCloud& target);
Alignment ndt(const LocalCloud& source, const LocalCloud& target);
/// Needs no start. Seeds std::rand.
Alignment alignFeatures(const LocalCloud& source, const LocalCloud& target, std::uint64_t seed);

}  // namespace posture
