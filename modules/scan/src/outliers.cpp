// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "outliers.h"

#include <boost/pending/disjoint_sets.hpp>

#include "blocks.h"
#include <algorithm>

namespace posture {
namespace {

/// Points in each point's group.
std::vector<int> groupSizes(const Points& points,
                            const NeighborTable& neighbors,
                            const std::vector<char>& keep,
                            double link) {
  const int n = static_cast<int>(points.rows());
  std::vector<int> rank(n), parent(n), size(n, 0), sizes(n);
  boost::disjoint_sets<int*, int*> groups(rank.data(), parent.data());
  for (int i = 0; i < n; ++i) groups.make_set(i);
  for (int i = 0; i < n; ++i) {
    if (!keep[i]) continue;
    for (int j : neighbors.row(i)) {
      if (j < 0 || (points.row(j) - points.row(i)).norm() > link) break;
      if (keep[j]) groups.union_set(i, j);
    }
  }
  for (int i = 0; i < n; ++i) ++size[groups.find_set(i)];
  for (int i = 0; i < n; ++i) sizes[i] = size[groups.find_set(i)];
  return sizes;
}

}  // namespace

std::vector<char> withoutOutliers(const Points& points,
                                  const NeighborTable& neighbors,
                                  double spacing) {
  const int n = static_cast<int>(points.rows());
  std::vector<char> keep(n, 0);
  forEach(n, [&](int i) {
    const int count = std::min(6, neighborCount(neighbors, i));
    keep[i] =
        count > 0 && (points.row(neighbors(i, count - 1)) - points.row(i)).norm() <= 4 * spacing;
  });
  // A scan of few points has no groups to compare.
  const int least = std::min(n / 2, std::max(30, n / 500));
  const std::vector<int> sizes = groupSizes(points, neighbors, keep, 3 * spacing);
  for (int i = 0; i < n; ++i) keep[i] = keep[i] && sizes[i] >= least;
  return keep;
}

}  // namespace posture
