// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "points/outliers.h"

#include <posture/core/parallel.h>
#include <posture/core/unions.h>

#include "points/local_quadric.h"
#include <algorithm>

namespace posture {
namespace {

/// Points in each point's group.
std::vector<int> groupSizes(const Points& points,
                            const NeighborTable& neighbors,
                            const std::vector<char>& keep,
                            const std::vector<double>& spacing) {
  const int n = static_cast<int>(points.rows());
  Unions groups(n);
  for (int i = 0; i < n; ++i) {
    if (!keep[i]) continue;
    for (int j : neighbors.row(i)) {
      if (j < 0 || (points.row(j) - points.row(i)).norm() > 3 * spacing[i]) break;
      if (keep[j] && (points.row(j) - points.row(i)).norm() <= 3 * spacing[j]) groups.join(i, j);
    }
  }
  return groups.sizes();
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

std::vector<char> withoutStrays(const Points& points,
                                const NeighborTable& neighbors,
                                const Spacing& spacing) {
  constexpr int NEAR = 12, FRIENDS = 4;
  // Most vertices of coarse parts have less, outliers among themselves 0.2 and more.
  constexpr double SMOOTH = 0.1;
  const int n = static_cast<int>(points.rows());
  std::vector<char> keep(n, 0);
  forEach(n, [&](int i) {
    const int count = neighborCount(neighbors, i);
    if (count < 3) return;
    const double third = (points.row(neighbors(i, 2)) - points.row(i)).norm();
    keep[i] =
        third <= 5 * spacing.median ||
        (count >= NEAR && quadricResidual<NEAR>(points, neighbors, i) < SMOOTH * spacing.at[i]);
  });
  const auto near = [&](int i) { return neighbors.row(i).head(NEAR); };
  const auto belongs = [&](int i) {
    int friends = 0;
    for (int j : near(i)) friends += j >= 0 && keep[j] && (near(j).array() == i).any();
    return friends >= FRIENDS;
  };
  std::vector<int> waiting;
  for (int i = 0; i < n; ++i)
    if (!keep[i]) waiting.push_back(i);
  for (bool found = true; found;) {
    const auto taken =
        std::stable_partition(waiting.begin(), waiting.end(), [&](int i) { return !belongs(i); });
    found = taken != waiting.end();
    for (auto i = taken; i != waiting.end(); ++i) keep[*i] = 1;
    waiting.erase(taken, waiting.end());
  }
  return keep;
}

}  // namespace posture
