// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/error.h>
#include <posture/mesh/point_index.h>

#include <pcl/kdtree/kdtree_flann.h>
#include <pcl/point_types.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace posture {

struct PointIndex::Tree {
  Eigen::Vector3d center;
  double unit = 1;
  pcl::KdTreeFLANN<pcl::PointXYZ> kdtree;

  pcl::PointXYZ local(const Eigen::Vector3d& point) const {
    const Eigen::Vector3f p = ((point - center) / unit).cast<float>();
    return {p.x(), p.y(), p.z()};
  }
};

PointIndex::PointIndex(const Points& points) {
  require(points.rows() > 0, "PointIndex: no points");
  auto tree = std::make_unique<Tree>();
  tree->center = points.colwise().mean();
  const double extent = (points.rowwise() - tree->center.transpose()).cwiseAbs().maxCoeff();
  // A power of two changes no digit.
  if (extent > 0) tree->unit = std::exp2(std::round(std::log2(extent)));
  auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  cloud->reserve(points.rows());
  for (int i = 0; i < points.rows(); ++i) cloud->push_back(tree->local(points.row(i)));
  tree->kdtree.setInputCloud(cloud);
  tree_ = std::move(tree);
}

PointIndex::~PointIndex() = default;
PointIndex::PointIndex(PointIndex&&) noexcept = default;
PointIndex& PointIndex::operator=(PointIndex&&) noexcept = default;

PointIndex::Neighbor PointIndex::nearest(const Eigen::Vector3d& query) const {
  return nearest(query, 1).front();
}

std::vector<PointIndex::Neighbor> PointIndex::nearest(const Eigen::Vector3d& query,
                                                      int count) const {
  std::vector<int> index;
  std::vector<float> distance_sq;
  tree_->kdtree.nearestKSearch(tree_->local(query), count, index, distance_sq);
  std::vector<Neighbor> neighbors;
  neighbors.reserve(index.size());
  for (std::size_t i = 0; i < index.size(); ++i)
    neighbors.push_back({index[i], tree_->unit * std::sqrt(static_cast<double>(distance_sq[i]))});
  return neighbors;
}

std::vector<int> PointIndex::within(const Eigen::Vector3d& query, double radius) const {
  constexpr double ROUNDING = 1e-6;  // of coordinates of order 1, in single precision
  std::vector<int> index;
  std::vector<float> distance_sq;
  const pcl::PointXYZ at = tree_->local(query);
  const double size = std::max({1.0f, std::abs(at.x), std::abs(at.y), std::abs(at.z)});
  tree_->kdtree.radiusSearch(at, radius / tree_->unit + ROUNDING * size, index, distance_sq);
  std::sort(index.begin(), index.end());
  return index;
}

}  // namespace posture
