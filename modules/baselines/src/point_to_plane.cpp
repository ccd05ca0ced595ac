// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/registration/icp.h>

#include "local_methods.h"
#include "normals.h"
#include "pcl_cloud.h"
#include "two_passes.h"

namespace posture {
namespace {

/// As PCL's example has it: these steps are long, and where they have not ended by then they go
/// round in circles.
constexpr int ITERATIONS = 50;

}  // namespace

Alignment icpPointToPlane(const LocalCloud& source, const LocalCloud& target) {
  pcl::IterativeClosestPointWithNormals<pcl::PointNormal, pcl::PointNormal, double> registration;
  registration.setInputSource(toPclWithNormals(withNormals(source)));
  registration.setInputTarget(toPclWithNormals(withNormals(target)));
  registration.setMaximumIterations(ITERATIONS);
  registration.setTransformationEpsilon(ICP_EPSILON);
  return twoPasses(registration);
}

}  // namespace posture
