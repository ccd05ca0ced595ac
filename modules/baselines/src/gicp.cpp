// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/registration/gicp.h>

#include "local_methods.h"
#include "pcl_cloud.h"
#include "two_passes.h"

namespace posture {

/// All else as PCL has it: 200 iterations, planes of 20 neighbours, epsilons in metres.
Alignment gicp(const LocalCloud& source, const LocalCloud& target) {
  pcl::GeneralizedIterativeClosestPoint<pcl::PointXYZ, pcl::PointXYZ> registration;
  registration.setInputSource(toPcl(source.points));
  registration.setInputTarget(toPcl(target.points));
  return twoPasses(registration);
}

}  // namespace posture
