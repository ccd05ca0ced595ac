// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/error.h>
#include <posture/core/finite_rows.h>
#include <posture/evaluation/closeness.h>
#include <posture/evaluation/statistics.h>
#include <posture/mesh/point_index.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace posture {
namespace {

constexpr int NEIGHBORS = 16;

Points seenOf(const Points& points) {
  const std::vector<int> seen = finiteRows(points);
  require(!seen.empty(), "no point");
  return points(seen, Eigen::all);
}

/// From each of `from` to the nearest of `to`.
std::vector<double> distances(const Points& from, const PointIndex& to) {
  std::vector<double> lengths(from.rows());
  for (int i = 0; i < from.rows(); ++i) lengths[i] = to.nearest(from.row(i)).distance;
  return lengths;
}

double spacingOf(const Points& finite, const PointIndex& index) {
  std::vector<double> spacings(finite.rows());
  for (int i = 0; i < finite.rows(); ++i) {
    const auto near = index.nearest(finite.row(i), NEIGHBORS + 1);  // the point itself among them
    const auto others = std::max<double>(1, static_cast<double>(near.size()) - 1);
    spacings[i] = near.back().distance * std::sqrt(M_PI / others);
  }
  return percentile(spacings, 0.5);
}

/// Of the box that holds the middle 98 % along each axis: one point thrown far out is no size.
double diagonalOf(const Points& points) {
  Eigen::Vector3d box;
  for (int k = 0; k < 3; ++k) {
    const std::vector<double> along(points.col(k).begin(), points.col(k).end());
    box[k] = percentile(along, 0.99) - percentile(along, 0.01);
  }
  return box.norm();
}

double shareWithin(const std::vector<double>& lengths, double limit) {
  const auto within =
      std::count_if(lengths.begin(), lengths.end(), [&](double l) { return l <= limit; });
  return static_cast<double>(within) / static_cast<double>(lengths.size());
}

}  // namespace

Closeness measureCloseness(const Points& moved, const Points& target) {
  const Points from = seenOf(moved), to = seenOf(target);
  const PointIndex from_index(from), to_index(to);
  const double spacing = spacingOf(to, to_index);
  const double diagonal = diagonalOf(to);
  const std::vector<double> there = distances(from, to_index), back = distances(to, from_index);
  return {mean(there) / diagonal, shareWithin(there, spacing), shareWithin(back, spacing)};
}

}  // namespace posture
