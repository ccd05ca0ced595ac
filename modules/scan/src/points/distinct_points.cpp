// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "points/distinct_points.h"

#include <posture/core/computable.h>
#include <posture/core/error.h>
#include <posture/core/finite_rows.h>
#include <posture/core/median.h>
#include <posture/mesh/moment_axes.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace posture {
namespace {

/// In units of the frame: far below the noise of any scanner, and eight digits above what turning
/// in double precision changes.
constexpr double GRID = 0x1p-22;

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

/// Place on the Z-order curve (Morton 1966) of a point within [-8, 8]^3, others at its border.
std::uint64_t curvePlace(const Eigen::RowVector3d& p) {
  std::uint64_t key = 0;
  for (int k = 0; k < 3; ++k) {
    const double cell = std::clamp((p[k] + 8) * 0x1p17, 0.0, 0x1p21 - 1);
    key |= spreadBits(static_cast<std::uint64_t>(cell)) << k;
  }
  return key;
}

/// Of rows at one place the first alone, sorted by place; `first_at` has it for each of them.
std::vector<int> firstRows(const Points& points,
                           std::vector<int> rows,
                           std::vector<int>& first_at) {
  std::sort(rows.begin(), rows.end(), [&](int a, int b) {
    for (int k = 0; k < 3; ++k)
      if (points(a, k) != points(b, k)) return points(a, k) < points(b, k);
    return a < b;
  });
  std::vector<int> firsts;
  for (int row : rows) {
    if (firsts.empty() || points.row(firsts.back()) != points.row(row)) firsts.push_back(row);
    first_at[row] = firsts.back();
  }
  return firsts;
}

/// Centre and extent, whatever the size of the numbers: a power of two, which costs them no digit.
ScanFrame roughFrame(const Points& points) {
  ScanFrame frame;
  double extent = 0;
  std::vector<double> values(points.rows());
  const std::size_t most = values.size() - 1 - values.size() / 20;
  for (int k = 0; k < 3; ++k) {
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = points(i, k);
    frame.center[k] = median(values);
    for (double& value : values) value = std::abs(value - frame.center[k]);
    std::nth_element(values.begin(), values.begin() + most, values.end());
    extent = std::max(extent, values[most]);
  }
  requireNotTooLarge(frame.center.cwiseAbs().maxCoeff() + extent);
  requireNotTooSmall(extent);
  if (extent > 0) frame.unit = std::exp2(std::round(std::log2(extent)));
  return frame;
}

/// Geometric median (Weiszfeld 1937). Every iterate turns with the points, converged or not, and
/// those from the mean on leave a share f of outliers behind by a factor f each.
Eigen::RowVector3d geometricMedian(const Points& points) {
  constexpr int ITERATIONS = 30;
  Eigen::RowVector3d center = points.colwise().mean();
  for (int iteration = 0; iteration < ITERATIONS; ++iteration) {
    const Vector pull = (points.rowwise() - center).rowwise().norm().cwiseMax(1e-9).cwiseInverse();
    center = pull.transpose() * points / pull.sum();
  }
  return center;
}

/// Leaves in `rows` those within a distance that single precision can square.
ScanFrame frameOf(const Points& given, std::vector<int>& rows) {
  const ScanFrame rough = roughFrame(given(rows, Eigen::all));
  Points points = rough.toWorking(given(rows, Eigen::all));
  constexpr double FAR = 1e9;
  std::vector<int> near;
  for (int i = 0; i < points.rows(); ++i)
    if (points.row(i).cwiseAbs().maxCoeff() < FAR) near.push_back(i);
  points = points(near, Eigen::all).eval();
  for (int& i : near) i = rows[i];
  rows = std::move(near);

  ScanFrame frame;
  const Eigen::RowVector3d center = geometricMedian(points);
  points.rowwise() -= center;
  const Vector distance = points.rowwise().norm();
  std::vector<double> distances(distance.begin(), distance.end());
  const double middle = std::max(median(distances), 1e-9);
  // Smooth weights (Tukey's biweight): no point is in or out by a rounding error.
  constexpr double REACH = 4;
  const Vector weight = (1 - (distance.array() / (REACH * middle)).square()).cwiseMax(0).square();
  frame.axes = momentAxes(points, weight);
  frame.center = rough.center + rough.unit * center;
  frame.unit = rough.unit * middle;
  return frame;
}

}  // namespace

Points ScanFrame::toWorking(const Points& points) const {
  return (points.rowwise() - center) / unit * axes;
}

Points ScanFrame::toCloud(const Points& points) const {
  return (unit * points * axes.transpose()).rowwise() + center;
}

DistinctPoints distinctPoints(const Points& points) {
  DistinctPoints distinct;
  std::vector<int> rows = finiteRows(points);
  distinct.missing = static_cast<int>(points.rows() - static_cast<Eigen::Index>(rows.size()));
  if (rows.empty())
    throw InputError(points.rows() == 0 ? "has no points" : "has no point with finite coordinates");
  const std::size_t finite = rows.size();
  std::vector<int> first_given(points.rows(), -1), first_at(points.rows(), -1);
  rows = firstRows(points, std::move(rows), first_given);
  if (rows.size() == 1) throw InputError("has all its points at one place");
  const std::size_t different = rows.size();
  distinct.frame = frameOf(points, rows);
  distinct.far = static_cast<int>(different - rows.size());
  Points working = Points::Zero(points.rows(), 3);
  for (int row : rows)
    working.row(row) = (distinct.frame.toWorking(points.row(row)).array() / GRID).round() * GRID;
  rows = firstRows(working, std::move(rows), first_at);
  distinct.repeated = static_cast<int>(finite - rows.size()) - distinct.far;
  constexpr std::size_t FEWEST = 32;
  if (rows.size() < FEWEST)
    throw InputError("has only " + std::to_string(rows.size()) +
                     " different points: a surface takes " + std::to_string(FEWEST));

  std::vector<std::pair<std::uint64_t, int>> order(rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i)
    order[i] = {curvePlace(working.row(rows[i])), static_cast<int>(i)};
  std::sort(order.begin(), order.end());
  distinct.points.resize(static_cast<Eigen::Index>(order.size()), 3);
  for (std::size_t i = 0; i < order.size(); ++i) {
    distinct.input.push_back(rows[order[i].second]);
    distinct.points.row(static_cast<Eigen::Index>(i)) = working.row(distinct.input.back());
  }
  std::vector<int> number(points.rows(), -1);
  for (std::size_t i = 0; i < distinct.input.size(); ++i)
    number[distinct.input[i]] = static_cast<int>(i);
  distinct.place.assign(points.rows(), -1);
  for (std::size_t row = 0; row < first_given.size(); ++row)
    if (first_given[row] >= 0 && first_at[first_given[row]] >= 0)
      distinct.place[row] = number[first_at[first_given[row]]];
  return distinct;
}

}  // namespace posture
