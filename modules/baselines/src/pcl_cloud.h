// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include "working_frame.h"

namespace posture {

inline pcl::PointCloud<pcl::PointXYZ>::Ptr toPcl(const Points& points) {
  auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  cloud->resize(points.rows());
  for (int i = 0; i < points.rows(); ++i)
    (*cloud)[i].getVector3fMap() = points.row(i).transpose().cast<float>();
  return cloud;
}

/// Points without a normal are left out. \pre  there are normals.
inline pcl::PointCloud<pcl::PointNormal>::Ptr toPclWithNormals(const LocalCloud& local) {
  auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointNormal>>();
  for (int i = 0; i < local.points.rows(); ++i) {
    const Eigen::Vector3d normal = local.normals.row(i).transpose().normalized();
    if (!normal.allFinite() || normal.isZero()) continue;
    pcl::PointNormal point;
    point.getVector3fMap() = local.points.row(i).transpose().cast<float>();
    point.getNormalVector3fMap() = normal.cast<float>();
    cloud->push_back(point);
  }
  return cloud;
}

}  // namespace posture
