// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "normals.h"

#include <pcl/features/normal_3d.h>

#include "pcl_cloud.h"

namespace posture {
namespace {

using Estimation = pcl::NormalEstimation<pcl::PointXYZ, pcl::Normal>;

LocalCloud withEstimated(const LocalCloud& cloud, Estimation& estimation) {
  const Eigen::Vector3d middle = cloud.points.colwise().mean();
  const Eigen::Vector3f viewpoint = cloud.sensor.value_or(middle).cast<float>();
  estimation.setInputCloud(toPcl(cloud.points));
  estimation.setViewPoint(viewpoint.x(), viewpoint.y(), viewpoint.z());
  pcl::PointCloud<pcl::Normal> normals;
  estimation.compute(normals);

  LocalCloud result = cloud;
  result.normals = Points::Zero(cloud.points.rows(), 3);
  const double sign = cloud.sensor ? 1 : -1;
  for (int i = 0; i < result.normals.rows(); ++i) {
    const Eigen::Vector3f normal = normals[i].getNormalVector3fMap();
    if (normal.allFinite()) result.normals.row(i) = sign * normal.transpose().cast<double>();
  }
  return result;
}

}  // namespace

LocalCloud withNormals(const LocalCloud& cloud) {
  if (cloud.normals.rows() > 0) return cloud;
  Estimation estimation;
  estimation.setKSearch(NORMAL_NEIGHBORS);
  return withEstimated(cloud, estimation);
}

LocalCloud withNormals(const LocalCloud& cloud, const Points& surface, double radius) {
  if (cloud.normals.rows() > 0) return cloud;
  Estimation estimation;
  estimation.setSearchSurface(toPcl(surface));
  estimation.setRadiusSearch(radius);
  return withEstimated(cloud, estimation);
}

}  // namespace posture
