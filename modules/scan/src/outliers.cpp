// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "outliers.h"

#include <posture/core/parallel.h>

#include <boost/pending/disjoint_sets.hpp>

#include "local_plane.h"
#include <algorithm>

namespace posture {
namespace {

/// Points in each point's group.
std::vector<int> groupSizes(const Points& points,
                            const NeighborTable& neighbors,
                            const std::vector<char>& keep,
                            const std::vector<double>& spacing) {
  const int n = static_cast<int>(points.rows());
  std::vector<int> rank(n), parent(n), size(n, 0), sizes(n);
  boost::disjoint_sets<int*, int*> groups(rank.data(), parent.data());
  for (int i = 0; i < n; ++i) groups.make_set(i);
  for (int i = 0; i < n; ++i) {
    if (!keep[i]) continue;
    for (int j : neighbors.row(i)) {
      if (j < 0 || (points.row(j) - points.row(i)).norm() > 3 * spacing[i]) break;
      if (keep[j] && (points.row(j) - points.row(i)).norm() <= 3 * spacing[j])
        groups.union_set(i, j);
    }
  }
  for (int i = 0; i < n; ++i) ++size[groups.find_set(i)];
  for (int i = 0; i < n; ++i) sizes[i] = size[groups.find_set(i)];
  return sizes;
}

/// Whether the ten nearest neighbours lie in a plane rather than anywhere.
bool isFlat(const Points& points, const NeighborTable& neighbors, int i) {
  const int count = std::min(10, neighborCount(neighbors, i));
  LocalPlane plane;
  plane.add(Eigen::Vector3d::Zero(), 1);
  double radius = 0;
  for (int k = 0; k < count; ++k) {
    const Eigen::Vector3d offset = (points.row(neighbors(i, k)) - points.row(i)).transpose();
    plane.add(offset, 1);
    radius = offset.norm();
  }
  return plane.fit().residual < 0.12 * radius;
}

}  // namespace

std::vector<char> withoutOutliers(const Points& points,
                                  const NeighborTable& neighbors,
                                  const Spacing& spacing) {
  const int n = static_cast<int>(points.rows());
  std::vector<char> keep(n, 0);
  std::vector<double> trusted(n, spacing.median);
  forEach(n, [&](int i) {
    const int count = std::min(6, neighborCount(neighbors, i));
    if (count == 0) return;
    if (spacing.at[i] > spacing.median && isFlat(points, neighbors, i)) trusted[i] = spacing.at[i];
    keep[i] = (points.row(neighbors(i, count - 1)) - points.row(i)).norm() <= 4 * trusted[i];
  });
  // A scan of few points has no groups to compare.
  const int least = std::min(n / 2, std::max(30, n / 500));
  const std::vector<int> sizes = groupSizes(points, neighbors, keep, trusted);
  for (int i = 0; i < n; ++i) keep[i] = keep[i] && sizes[i] >= least;
  return keep;
}

}  // namespace posture
