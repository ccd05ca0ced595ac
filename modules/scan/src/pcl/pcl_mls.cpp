// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/point_types.h>
#include <pcl/search/kdtree.h>

#include "pcl/pcl_surfaces.h"
// The templates themselves: libpcl_surface, which has them compiled, links VTK.
#include <pcl/surface/impl/mls.hpp>
#include <pcl/surface/mls.h>

namespace posture {

OrientedPoints movingLeastSquares(const Points& points, double radius) {
  auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  for (int i = 0; i < points.rows(); ++i) {
    const Eigen::RowVector3f p = points.row(i).cast<float>();
    cloud->push_back({p.x(), p.y(), p.z()});
  }
  pcl::MovingLeastSquares<pcl::PointXYZ, pcl::PointNormal> mls;
  mls.setInputCloud(cloud);
  mls.setSearchMethod(pcl::make_shared<pcl::search::KdTree<pcl::PointXYZ>>());
  mls.setSearchRadius(radius);
  mls.setPolynomialOrder(2);
  mls.setComputeNormals(true);
  pcl::PointCloud<pcl::PointNormal> moved;
  mls.process(moved);

  OrientedPoints result{points, Points::Zero(points.rows(), 3)};
  result.normals.col(2).setOnes();
  const auto& index = mls.getCorrespondingIndices()->indices;
  for (std::size_t i = 0; i < moved.size(); ++i) {
    const Eigen::RowVector3d point = moved[i].getVector3fMap().transpose().cast<double>();
    const Eigen::RowVector3d normal =
        moved[i].getNormalVector3fMap().transpose().cast<double>().normalized();
    if (!point.allFinite() || !normal.allFinite()) continue;
    result.points.row(index[i]) = point;
    result.normals.row(index[i]) = normal;
  }
  return result;
}

}  // namespace posture
