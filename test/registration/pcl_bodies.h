// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/mesh/normals.h>

#include <pcl/Vertices.h>
#include <pcl/memory.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <cstring>
#include <vector>

namespace posture::test {

template <class PointT>
typename pcl::PointCloud<PointT>::Ptr toCloud(const Points& points) {
  auto cloud = pcl::make_shared<pcl::PointCloud<PointT>>();
  for (int i = 0; i < points.rows(); ++i) {
    PointT point;
    point.getVector3fMap() = points.row(i).transpose().cast<float>();
    cloud->push_back(point);
  }
  return cloud;
}

/// With the normals of the surface, and other fields that tell the points apart.
inline pcl::PointCloud<pcl::PointXYZRGBNormal>::Ptr toColoredCloud(const TriangleMesh& mesh) {
  auto cloud = toCloud<pcl::PointXYZRGBNormal>(mesh.vertices);
  const Points normals = vertexNormals(mesh);
  for (int i = 0; i < normals.rows(); ++i) {
    pcl::PointXYZRGBNormal& point = (*cloud)[i];
    point.getNormalVector3fMap() = normals.row(i).transpose().cast<float>();
    point.rgba = 0xff000000u + static_cast<std::uint32_t>(i);
    point.curvature = 0.5f * static_cast<float>(i);
  }
  return cloud;
}

inline std::vector<pcl::Vertices> toPolygons(const Faces& faces) {
  std::vector<pcl::Vertices> polygons(faces.rows());
  for (int f = 0; f < faces.rows(); ++f)
    for (int k = 0; k < 3; ++k) polygons[f].vertices.push_back(faces(f, k));
  return polygons;
}

/// Same points, bit for bit.
template <class PointT>
bool sameBytes(const pcl::PointCloud<PointT>& a, const pcl::PointCloud<PointT>& b) {
  return a.size() == b.size() &&
         std::memcmp(a.points.data(), b.points.data(), a.size() * sizeof(PointT)) == 0;
}

}  // namespace posture::test
