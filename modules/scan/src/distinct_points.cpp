// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "distinct_points.h"

#include <posture/core/error.h>
#include <posture/core/finite_rows.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <utility>

namespace posture {
namespace {

/// The bits of the lowest 21 of x, two zeros after each.
std::uint64_t spreadBits(std::uint64_t x) {
  x &= 0x1fffff;
  x = (x | x << 32) & 0x1f00000000ffffull;
  x = (x | x << 16) & 0x1f0000ff0000ffull;
  x = (x | x << 8) & 0x100f00f00f00f00full;
  x = (x | x << 4) & 0x10c30c30c30c30c3ull;
  x = (x | x << 2) & 0x1249249249249249ull;
  return x;
}

/// Place on the Z-order curve (Morton 1966) of a point within [-4, 4]^3, others at its border.
std::uint64_t curvePlace(const Eigen::RowVector3d& p) {
  std::uint64_t key = 0;
  for (int k = 0; k < 3; ++k) {
    const double cell = std::clamp((p[k] + 4) * 0x1p18, 0.0, 0x1p21 - 1);
    key |= spreadBits(static_cast<std::uint64_t>(cell)) << k;
  }
  return key;
}

/// Rows by place; at one place by number.
void sortByPlace(const Points& points, std::vector<int>& rows) {
  std::sort(rows.begin(), rows.end(), [&](int a, int b) {
    for (int k = 0; k < 3; ++k)
      if (points(a, k) != points(b, k)) return points(a, k) < points(b, k);
    return a < b;
  });
}

/// Robust: a far outlier must not cost the body its digits.
WorkingFrame workingFrame(const Points& points, const std::vector<int>& rows) {
  WorkingFrame frame;
  double extent = 0;
  std::vector<double> values(rows.size());
  const std::size_t middle = rows.size() / 2, most = rows.size() - 1 - rows.size() / 20;
  for (int k = 0; k < 3; ++k) {
    for (std::size_t i = 0; i < rows.size(); ++i) values[i] = points(rows[i], k);
    std::nth_element(values.begin(), values.begin() + middle, values.end());
    frame.center[k] = values[middle];
    for (double& value : values) value = std::abs(value - frame.center[k]);
    std::nth_element(values.begin(), values.begin() + most, values.end());
    extent = std::max(extent, values[most]);
  }
  if (extent > 0 && std::isfinite(extent)) frame.unit = std::exp2(std::round(std::log2(extent)));
  return frame;
}

}  // namespace

Points WorkingFrame::toWorking(const Points& points) const {
  return (points.rowwise() - center.transpose()) / unit;
}

Points WorkingFrame::toCloud(const Points& points) const {
  return (points * unit).rowwise() + center.transpose();
}

DistinctPoints distinctPoints(const Points& points) {
  DistinctPoints distinct;
  std::vector<int> rows = finiteRows(points);
  distinct.missing = static_cast<int>(points.rows() - static_cast<Eigen::Index>(rows.size()));
  if (rows.empty())
    throw InputError(points.rows() == 0 ? "has no points" : "has no point with finite coordinates");
  sortByPlace(points, rows);
  // Of equal rows the first stands for all.
  std::vector<int> first_at(points.rows(), -1);
  std::vector<int> firsts;
  for (int row : rows) {
    if (firsts.empty() || points.row(firsts.back()) != points.row(row)) firsts.push_back(row);
    first_at[row] = firsts.back();
  }
  distinct.repeated = static_cast<int>(rows.size() - firsts.size());
  rows = std::move(firsts);
  if (rows.size() == 1) throw InputError("has all its points at one place");
  constexpr std::size_t FEWEST = 32;
  if (rows.size() < FEWEST)
    throw InputError("has only " + std::to_string(rows.size()) +
                     " different points: a surface takes " + std::to_string(FEWEST));

  distinct.frame = workingFrame(points, rows);
  const Points working = distinct.frame.toWorking(points(rows, Eigen::all));
  std::vector<std::pair<std::uint64_t, int>> order(rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i)
    order[i] = {curvePlace(working.row(i)), static_cast<int>(i)};
  std::sort(order.begin(), order.end());
  distinct.points.resize(order.size(), 3);
  for (std::size_t i = 0; i < order.size(); ++i) {
    distinct.points.row(i) = working.row(order[i].second);
    distinct.input.push_back(rows[order[i].second]);
  }
  std::vector<int> number(points.rows(), -1);
  for (std::size_t i = 0; i < distinct.input.size(); ++i)
    number[distinct.input[i]] = static_cast<int>(i);
  distinct.place.resize(points.rows());
  for (std::size_t row = 0; row < first_at.size(); ++row)
    distinct.place[row] = first_at[row] < 0 ? -1 : number[first_at[row]];
  return distinct;
}

}  // namespace posture
