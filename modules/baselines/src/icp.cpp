// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/registration/icp.h>

#include "local_methods.h"
#include "pcl_cloud.h"
#include "two_passes.h"

namespace posture {
namespace {

/// Transforms in double precision: in single precision the criterion is below what can be told.
using Icp = pcl::IterativeClosestPoint<pcl::PointXYZ, pcl::PointXYZ, double>;

void setUp(Icp& registration, const LocalCloud& source, const LocalCloud& target) {
  registration.setInputSource(toPcl(source.points));
  registration.setInputTarget(toPcl(target.points));
  registration.setMaximumIterations(ICP_ITERATIONS);
  registration.setTransformationEpsilon(ICP_EPSILON);
}

}  // namespace

Alignment icp(const LocalCloud& source, const LocalCloud& target) {
  Icp registration;
  setUp(registration, source, target);
  return twoPasses(registration);
}

Alignment fineIcp(const LocalCloud& source,
                  const LocalCloud& target,
                  const Eigen::Matrix4d& start) {
  Icp registration;
  setUp(registration, source, target);
  return finePass(registration, start);
}

}  // namespace posture
