// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "finite_search.h"
#include "local_methods.h"
#include <cmath>
#include <limits>

namespace posture {

/// PCL's default: no limit.
inline double anyDistance() { return std::sqrt(std::numeric_limits<double>::max()); }

/// Runs a registration of PCL from `start` with a bound on the distance of correspondences. Where
/// it does not converge the motion is as far as it came.
template <class Registration>
Alignment pass(Registration& registration, const Eigen::Matrix4d& start, double largest_distance) {
  typename Registration::PointCloudSource moved;
  registration.setMaxCorrespondenceDistance(largest_distance);
  registration.setSearchMethodTarget(
      pcl::make_shared<FiniteSearch<typename Registration::PointCloudTarget::PointType>>());
  try {
    registration.align(moved, start.cast<typename Registration::Matrix4::Scalar>());
  } catch (const NoMotion&) {
    return {start, false};
  }
  const Eigen::Matrix4d motion = registration.getFinalTransformation().template cast<double>();
  if (!motion.allFinite()) return {start, false};
  return {motion, registration.hasConverged()};
}

template <class Registration>
Alignment finePass(Registration& registration, const Eigen::Matrix4d& start) {
  registration.setUseReciprocalCorrespondences(true);
  return pass(registration, start, FINE_DISTANCE);
}

/// First with all correspondences, which reaches far, then with near ones that each side finds
/// (GICP knows no such choice), which leaves out what the other side does not have.
template <class Registration>
Alignment twoPasses(Registration& registration) {
  const Alignment coarse = pass(registration, Eigen::Matrix4d::Identity(), anyDistance());
  return finePass(registration, coarse.motion);
}

}  // namespace posture
