// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/registration/register_clouds.h>
#include <posture/registration/single_precision.h>

#include <pcl/PCLPointCloud2.h>
#include <pcl/conversions.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/types.h>

#include <algorithm>
#include <numeric>
#include <string>
#include <vector>

namespace posture {

/// Positions and normals of all points.
template <typename PointT>
PointCloud toPointCloud(const pcl::PointCloud<PointT>& from) {
  const auto n = static_cast<Eigen::Index>(from.size());
  PointCloud cloud;
  cloud.points.resize(n, 3);
  for (Eigen::Index i = 0; i < n; ++i)
    cloud.points.row(i) = from[i].getVector3fMap().template cast<double>().transpose();
  if constexpr (pcl::traits::has_normal<PointT>::value) {
    cloud.normals.resize(n, 3);
    for (Eigen::Index i = 0; i < n; ++i)
      cloud.normals.row(i) = from[i].getNormalVector3fMap().template cast<double>().transpose();
  }
  return cloud;
}

/// Writes positions, and normals where the points have them, into points that are finite.
template <typename PointT>
void writePlaces(const Points& places, const Points& normals, pcl::PointCloud<PointT>& to) {
  for (Eigen::Index i = 0; i < places.rows(); ++i) {
    if (!places.row(i).allFinite()) continue;
    to[i].getVector3fMap() = places.row(i).transpose().template cast<float>();
    if constexpr (pcl::traits::has_normal<PointT>::value)
      to[i].getNormalVector3fMap() = normals.row(i).transpose().template cast<float>();
  }
}

/// Whether a cloud has a field: conversions print where it has not.
inline bool hasField(const pcl::PCLPointCloud2& cloud, const char* name) {
  return std::any_of(cloud.fields.begin(),
                     cloud.fields.end(),
                     [&](const pcl::PCLPointField& field) { return field.name == name; });
}

/// None where the cloud has no positions.
template <typename PointT>
pcl::PointCloud<PointT> pointsOf(const pcl::PCLPointCloud2& cloud) {
  pcl::PointCloud<PointT> points;
  if (hasField(cloud, "x")) pcl::fromPCLPointCloud2(inSinglePrecision(cloud), points);
  return points;
}

/// None where the cloud has none.
inline Points toNormals(const pcl::PCLPointCloud2& normals) {
  pcl::PointCloud<pcl::Normal> cloud;
  if (hasField(normals, "normal_x")) pcl::fromPCLPointCloud2(inSinglePrecision(normals), cloud);
  Points rows(static_cast<Eigen::Index>(cloud.size()), 3);
  for (std::size_t i = 0; i < cloud.size(); ++i)
    rows.row(static_cast<Eigen::Index>(i)) =
        cloud[i].getNormalVector3fMap().cast<double>().transpose();
  return rows;
}

template <typename PointT>
bool hasFinitePoint(const pcl::PointCloud<PointT>& cloud) {
  return std::any_of(
      cloud.begin(), cloud.end(), [](const PointT& p) { return p.getVector3fMap().allFinite(); });
}

template <typename PointT>
pcl::Indices allOf(const pcl::PointCloud<PointT>& cloud) {
  pcl::Indices indices(cloud.size());
  std::iota(indices.begin(), indices.end(), 0);
  return indices;
}

/// The points of a cloud that take part. A whole organised cloud is one view; of the sensor the
/// cloud says nothing where it is at the origin, which clouds keep as they are moved.
/// \param normals  instead of those of the points, if there is one for each point of the input.
template <typename PointT>
CloudSide cloudSide(const pcl::PointCloud<PointT>& input,
                    const pcl::Indices& indices,
                    const std::vector<pcl::Vertices>& polygons,
                    const Points& normals = {}) {
  CloudSide side;
  if (input.empty()) return side;  // whatever indices are left of another input
  for (const pcl::index_t i : indices)
    if (i < 0 || static_cast<std::size_t>(i) >= input.size()) {
      side.fault =
          "index " + std::to_string(i) + " names no point of " + std::to_string(input.size());
      return side;
    }
  side.cloud = toPointCloud(pcl::PointCloud<PointT>(input, indices));
  if (normals.rows() == static_cast<Eigen::Index>(input.size()))
    side.cloud.normals = normals(indices, Eigen::all);
  side.number.assign(indices.begin(), indices.end());
  side.total = input.size();
  side.polygons = polygons;
  const bool is_grid = input.height > 1 && input.width > 1 && indices == allOf(input);
  if (is_grid) side.cloud.width = static_cast<int>(input.width);
  const Eigen::Vector3d sensor = input.sensor_origin_.template head<3>().template cast<double>();
  if (!sensor.isZero(0)) side.cloud.sensor = sensor;
  return side;
}

}  // namespace posture
