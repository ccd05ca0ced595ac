// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/PolygonMesh.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include "points/oriented_points.h"
#include <vector>

namespace posture {

inline pcl::PointCloud<pcl::PointNormal>::Ptr toPclCloud(const OrientedPoints& oriented) {
  auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointNormal>>();
  cloud->resize(oriented.points.rows());
  for (int i = 0; i < oriented.points.rows(); ++i) {
    (*cloud)[i].getVector3fMap() = oriented.points.row(i).transpose().cast<float>();
    (*cloud)[i].getNormalVector3fMap() = oriented.normals.row(i).transpose().cast<float>();
  }
  return cloud;
}

inline Faces toFaces(const std::vector<pcl::Vertices>& polygons) {
  Faces faces(static_cast<Eigen::Index>(polygons.size()), 3);
  for (std::size_t f = 0; f < polygons.size(); ++f)
    for (int k = 0; k < 3; ++k)
      faces(static_cast<Eigen::Index>(f), k) = static_cast<int>(polygons[f].vertices[k]);
  return faces;
}

}  // namespace posture
