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

  struct Query {
    pcl::PointXYZ point;
    double unit;      ///< of distances from it
    double rounding;  ///< what these may be off by, in that unit
  };

  /// From far off, single precision tells no point from the next, and in the end squares nothing.
  /// What is farther is drawn nearer, along its way to the centre.
  Query local(const Eigen::Vector3d& query) const {
    require(query.allFinite(), "PointIndex: from a place that is not finite");
    constexpr double FAR = 1e3, FARTHEST = 1e305, ROUNDING = 1e-6;
    const Eigen::Vector3d p = ((query - center) / unit).cwiseMax(-FARTHEST).cwiseMin(FARTHEST);
    const double size = std::max(p.cwiseAbs().maxCoeff(), 1.0);
    const double nearer = std::max(size / FAR, 1.0);
    const Eigen::Vector3f at = (p / nearer).cast<float>();
    constexpr double BODY = 4;  // across, in units: its points move by so much against the query
    return {{at.x(), at.y(), at.z()}, unit * nearer, nearer > 1 ? BODY : ROUNDING * size};
  }

  pcl::PointXYZ stored(const Eigen::Vector3d& point) const {
    const Eigen::Vector3f p = ((point - center) / unit).cast<float>();
    return {p.x(), p.y(), p.z()};
  }
};

PointIndex::PointIndex(const Points& points) {
  require(points.rows() > 0, "PointIndex: no points");
  require(points.allFinite(), "PointIndex: a point that is not finite");
  auto tree = std::make_unique<Tree>();
  tree->center = points.colwise().mean();
  const double extent = (points.rowwise() - tree->center.transpose()).cwiseAbs().maxCoeff();
  // A power of two changes no digit.
  if (extent > 0) tree->unit = std::exp2(std::round(std::log2(extent)));
  auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  cloud->reserve(points.rows());
  for (int i = 0; i < points.rows(); ++i) cloud->push_back(tree->stored(points.row(i)));
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
  const Tree::Query at = tree_->local(query);
  tree_->kdtree.nearestKSearch(at.point, count, index, distance_sq);
  std::vector<Neighbor> neighbors;
  neighbors.reserve(index.size());
  for (std::size_t i = 0; i < index.size(); ++i)
    neighbors.push_back({index[i], at.unit * std::sqrt(static_cast<double>(distance_sq[i]))});
  return neighbors;
}

std::vector<int> PointIndex::within(const Eigen::Vector3d& query, double radius) const {
  std::vector<int> index;
  std::vector<float> distance_sq;
  const Tree::Query at = tree_->local(query);
  tree_->kdtree.radiusSearch(at.point, radius / at.unit + at.rounding, index, distance_sq);
  std::sort(index.begin(), index.end());
  return index;
}

}  // namespace posture
