// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/filters/approximate_voxel_grid.h>
#include <pcl/registration/ndt.h>

#include "local_methods.h"
#include "pcl_cloud.h"

namespace posture {
namespace {

// The tutorial's figures for a room, in metres.
constexpr float CELL = 1.0f;
constexpr float LEAF = 0.2f;
constexpr double STEP = 0.1;
/// The tutorial has 0.01, the least change in metres. PCL 1.13 compares it with a squared length,
/// which no step exceeds; it would end after the first.
constexpr double LEAST_CHANGE_SQ = 0.01 * 0.01;
constexpr int ITERATIONS = 100;

}  // namespace

Alignment ndt(const LocalCloud& source, const LocalCloud& target) {
  auto filtered = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  pcl::ApproximateVoxelGrid<pcl::PointXYZ> filter;
  filter.setLeafSize(LEAF, LEAF, LEAF);
  filter.setInputCloud(toPcl(source.points));
  filter.filter(*filtered);

  pcl::NormalDistributionsTransform<pcl::PointXYZ, pcl::PointXYZ> registration;
  registration.setTransformationEpsilon(LEAST_CHANGE_SQ);
  registration.setStepSize(STEP);
  registration.setResolution(CELL);
  registration.setMaximumIterations(ITERATIONS);
  registration.setInputSource(filtered);
  registration.setInputTarget(toPcl(target.points));
  pcl::PointCloud<pcl::PointXYZ> moved;
  registration.align(moved);
  return {registration.getFinalTransformation().cast<double>(), registration.hasConverged()};
}

}  // namespace posture
