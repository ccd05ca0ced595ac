// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/baselines/rigid_registration.h>
#include <posture/core/silent_pcl.h>

#include "local_methods.h"
#include "working_frame.h"
#include <exception>

namespace posture {
namespace {

Alignment align(RigidMethod method,
                const LocalCloud& source,
                const LocalCloud& target,
                std::uint64_t seed) {
  switch (method) {
    case RigidMethod::ICP:
      return icp(source, target);
    case RigidMethod::ICP_POINT_TO_PLANE:
      return icpPointToPlane(source, target);
    case RigidMethod::GICP:
      return gicp(source, target);
    case RigidMethod::NDT:
      return ndt(source, target);
    case RigidMethod::FPFH_ICP:
      break;
  }
  const Alignment start = alignFeatures(source, target, seed);
  return start.converged ? fineIcp(source, target, start.motion) : start;
}

}  // namespace

const std::vector<RigidMethod>& rigidMethods() {
  static const std::vector<RigidMethod> METHODS{RigidMethod::ICP,
                                                RigidMethod::ICP_POINT_TO_PLANE,
                                                RigidMethod::GICP,
                                                RigidMethod::NDT,
                                                RigidMethod::FPFH_ICP};
  return METHODS;
}

std::string nameOf(RigidMethod method) {
  static const char* const NAMES[] = {"ICP", "ICP point to plane", "GICP", "NDT", "FPFH + ICP"};
  return NAMES[static_cast<int>(method)];
}

std::string keyOf(RigidMethod method) {
  static const char* const KEYS[] = {"icp", "icp-point-to-plane", "gicp", "ndt", "fpfh-icp"};
  return KEYS[static_cast<int>(method)];
}

RigidResult registerRigidly(RigidMethod method,
                            const PointCloud& source,
                            const PointCloud& target,
                            std::uint64_t seed) {
  const WorkingFrame frame(target.points, method == RigidMethod::NDT ? ROOM_SIZE : OBJECT_SIZE);
  const LocalCloud from = frame.local(source), to = frame.local(target);
  const SilentPcl silent;
  RigidResult result;
  try {
    const Alignment found = align(method, from, to, seed);
    if (!found.motion.allFinite()) {
      result.failure = "the motion is not a number";
      return result;
    }
    result.T_target_source = frame.given(found.motion);
    result.converged = found.converged;
  } catch (const std::exception& error) {
    result.failure = error.what();
  }
  return result;
}

}  // namespace posture
