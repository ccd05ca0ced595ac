// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "points/neighbors.h"

#include <posture/core/parallel.h>

#include <pcl/kdtree/kdtree_flann.h>
#include <pcl/point_types.h>

#include <algorithm>

namespace posture {
namespace {

pcl::PointXYZ toPcl(const Eigen::Vector3d& p) {
  return {static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())};
}

}  // namespace

struct NeighborSearch::Tree {
  pcl::PointCloud<pcl::PointXYZ>::Ptr cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  pcl::KdTreeFLANN<pcl::PointXYZ> kdtree;

  /// Itself left out: points that single precision cannot tell apart may come before it.
  int nearest(int i, int count, std::vector<int>& index, std::vector<float>& distance_sq) const {
    const int found = kdtree.nearestKSearch((*cloud)[i], count + 1, index, distance_sq);
    index.resize(found);
    const auto self = std::find(index.begin(), index.end(), i);
    index.erase(self == index.end() ? index.end() - 1 : self);
    return static_cast<int>(index.size());
  }
};

NeighborSearch::NeighborSearch(const Points& points) {
  auto tree = std::make_unique<Tree>();
  tree->cloud->reserve(points.rows());
  for (int i = 0; i < points.rows(); ++i) tree->cloud->push_back(toPcl(points.row(i)));
  tree->kdtree.setInputCloud(tree->cloud);
  tree_ = std::move(tree);
}

NeighborSearch::~NeighborSearch() = default;
NeighborSearch::NeighborSearch(NeighborSearch&&) noexcept = default;
NeighborSearch& NeighborSearch::operator=(NeighborSearch&&) noexcept = default;

std::vector<int> NeighborSearch::nearest(int i, int count) const {
  std::vector<int> index;
  std::vector<float> distance_sq;
  tree_->nearest(i, count, index, distance_sq);
  return index;
}

std::vector<int> NeighborSearch::within(const Eigen::Vector3d& place, double radius) const {
  std::vector<int> index;
  std::vector<float> distance_sq;
  tree_->kdtree.radiusSearch(toPcl(place), radius, index, distance_sq);
  return index;
}

NeighborTable NeighborSearch::table(int count) const {
  const int n = static_cast<int>(tree_->cloud->size());
  count = std::min(count, n - 1);
  NeighborTable table = NeighborTable::Constant(n, count, -1);
  forBlocks(n, [&](int first, int last) {
    std::vector<int> index;
    std::vector<float> distance_sq;
    for (int i = first; i < last; ++i) {
      const int found = tree_->nearest(i, count, index, distance_sq);
      std::copy_n(index.begin(), found, table.row(i).data());
    }
  });
  return table;
}

int neighborCount(const NeighborTable& table, int row) {
  int count = static_cast<int>(table.cols());
  while (count > 0 && table(row, count - 1) < 0) --count;
  return count;
}

}  // namespace posture
