// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "normals.h"

#include <pcl/features/normal_3d.h>

#include "pcl_cloud.h"

namespace posture {

LocalCloud withNormals(const LocalCloud& cloud, double radius) {
  if (cloud.normals.rows() > 0) return cloud;
  const Eigen::Vector3d middle = cloud.points.colwise().mean();
  const Eigen::Vector3f viewpoint = cloud.sensor.value_or(middle).cast<float>();
  pcl::NormalEstimation<pcl::PointXYZ, pcl::Normal> estimation;
  estimation.setInputCloud(toPcl(cloud.points));
  if (radius > 0)
    estimation.setRadiusSearch(radius);
  else
    estimation.setKSearch(NORMAL_NEIGHBORS);
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

}  // namespace posture
