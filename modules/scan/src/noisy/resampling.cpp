// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "noisy/resampling.h"

#include <posture/core/median.h>
#include <posture/core/parallel.h>

#include "points/local_plane.h"
#include "points/spacing.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <utility>

namespace posture {
namespace {

/// Points whose neighbourhoods are looked at, evenly spread over their order.
constexpr int LOOKED_AT = 1500;

/// Neighbourhoods of so many points, doubled, are tried: from what shows a plane where there is no
/// noise to what a fine scan has within its noise, and no more than a part of the cloud.
constexpr int FEWEST = 10, MOST = 5120, PART_OF_CLOUD = 16;

/// Thickness of the neighbourhoods of some points, relative to their radius: median.
double relativeThickness(const Points& points, const NeighborSearch& search, int neighbors) {
  const int n = static_cast<int>(points.rows()), looked_at = std::min(n, LOOKED_AT);
  std::vector<double> thickness(looked_at);
  parallelFor(looked_at, [&](int s) {
    const int i = static_cast<int>(static_cast<std::int64_t>(s) * n / looked_at);
    const std::vector<int> near = search.nearest(i, neighbors);
    LocalPlane plane;
    plane.add(Eigen::Vector3d::Zero(), 1);
    double radius = 0;
    for (int j : near) {
      const Eigen::Vector3d offset = (points.row(j) - points.row(i)).transpose();
      plane.add(offset, 1);
      radius = std::max(radius, offset.norm());
    }
    thickness[s] = radius > 0 ? plane.fit().residual / radius : 0;
  });
  return lowerMedian(std::move(thickness));
}

}  // namespace

NoiseScale noiseScale(const Points& points, const NeighborSearch& search) {
  constexpr double FLAT = 0.20, FLATTEST_DOUBLE_WALL = 0.16;
  NoiseScale scale;
  double least = std::numeric_limits<double>::infinity();
  int flat_at = 0;
  for (int k = FEWEST; k <= MOST && k < points.rows() / PART_OF_CLOUD; k *= 2) {
    const double thickness = relativeThickness(points, search, k);
    least = std::min(least, thickness);
    if (flat_at == 0 && thickness < FLAT) flat_at = k;
    if (least < FLATTEST_DOUBLE_WALL && flat_at > 0) break;
  }
  scale.double_walls = std::isfinite(least) && least > FLATTEST_DOUBLE_WALL;
  if (flat_at > 0) scale.neighbors = flat_at;
  return scale;
}

Cells averageInCells(const Points& points, double side) {
  const int n = static_cast<int>(points.rows());
  using Key = std::array<std::int64_t, 3>;
  std::vector<std::pair<Key, int>> order(n);
  for (int i = 0; i < n; ++i) {
    for (int k = 0; k < 3; ++k)
      order[i].first[k] = static_cast<std::int64_t>(std::floor(points(i, k) / side));
    order[i].second = i;
  }
  std::sort(order.begin(), order.end());
  // Numbered by their first point, so that they lie along the same curve as the points.
  std::vector<int> first_of(n);
  for (int r = 0, start = 0; r < n; ++r) {
    if (order[r].first != order[start].first) start = r;
    first_of[order[r].second] = order[start].second;
  }
  Cells cells;
  cells.cell.resize(n);
  std::vector<int> size;
  std::vector<Eigen::RowVector3d> sum;
  for (int i = 0; i < n; ++i) {
    if (first_of[i] == i) {
      cells.cell[i] = static_cast<int>(size.size());
      size.push_back(0);
      sum.emplace_back(Eigen::RowVector3d::Zero());
    }
    const int c = cells.cell[i] = cells.cell[first_of[i]];
    ++size[c];
    sum[c] += points.row(i);
  }
  cells.means.resize(size.size(), 3);
  for (std::size_t c = 0; c < size.size(); ++c) cells.means.row(c) = sum[c] / size[c];
  return cells;
}

}  // namespace posture
