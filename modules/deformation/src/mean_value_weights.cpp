// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "mean_value_weights.h"

#include <Eigen/Dense>

#include "polygon_frame.h"
#include <algorithm>
#include <cmath>

namespace posture {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

/// Mean-value coordinates of the origin, not normalised.
std::vector<double> meanValueCoordinates(const std::vector<Vector2d>& corners) {
  constexpr double ON_SIDE = 1e-9;
  const std::size_t count = corners.size();
  std::vector<double> weight(count, 0.0), half_tangent(count);
  double largest = 0;
  for (const Vector2d& p : corners) largest = std::max(largest, p.norm());
  for (std::size_t k = 0; k < count; ++k) {
    if (corners[k].norm() > ON_SIDE * largest) continue;
    weight[k] = 1;
    return weight;
  }
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t next = (k + 1) % count;
    const Vector2d &a = corners[k], &b = corners[next];
    const double cross = a.x() * b.y() - a.y() * b.x(), dot = a.dot(b);
    const double product = a.norm() * b.norm();
    if (dot < 0 && std::abs(cross) <= ON_SIDE * product) {
      weight[k] = b.norm();
      weight[next] = a.norm();
      return weight;
    }
    half_tangent[k] = dot > 0 ? cross / (product + dot) : (product - dot) / cross;
  }
  for (std::size_t k = 0; k < count; ++k)
    weight[k] = (half_tangent[(k + count - 1) % count] + half_tangent[k]) / corners[k].norm();
  return weight;
}

/// Makes sum w = 1 and sum w p = 0 exact to rounding, by the least change.
void correct(const std::vector<Vector2d>& corners, std::vector<double>& weight) {
  Matrix3d gram = Matrix3d::Zero();
  Vector3d missing(1, 0, 0);
  double largest = 0;
  for (const Vector2d& p : corners) largest = std::max(largest, p.norm());
  const auto row = [&](std::size_t k) -> Vector3d {
    return {1, corners[k].x() / largest, corners[k].y() / largest};
  };
  for (std::size_t k = 0; k < corners.size(); ++k) {
    gram += row(k) * row(k).transpose();
    missing -= weight[k] * row(k);
  }
  const Vector3d change = gram.ldlt().solve(missing);
  for (std::size_t k = 0; k < corners.size(); ++k) weight[k] += change.dot(row(k));
}

}  // namespace

std::optional<std::vector<double>> meanValueWeights(const Vector3d& place,
                                                    const std::vector<Vector3d>& corners,
                                                    bool any) {
  constexpr double LEAST_FLATNESS = 0.1, LEAST_AREA = 0.02, MOST_CANCELLING = 5;
  const PolygonFrame frame(corners);
  const double area = frame.area.norm();
  if (!(area > 0)) return std::nullopt;
  if (!any &&
      (area < LEAST_FLATNESS * frame.fan_area || area < LEAST_AREA * frame.radius * frame.radius))
    return std::nullopt;
  const Matrix3d to_plane = polygonAxes(frame, corners).transpose();
  std::vector<Vector2d> flat;
  for (const Vector3d& p : corners) flat.push_back((to_plane * (p - place)).head<2>());
  std::vector<double> weight = meanValueCoordinates(flat);
  double sum = 0, absolute = 0;
  for (double w : weight) {
    sum += w;
    absolute += std::abs(w);
  }
  if (!any && !(absolute <= MOST_CANCELLING * std::abs(sum))) return std::nullopt;
  for (double& w : weight) w /= sum;
  correct(flat, weight);
  return weight;
}

}  // namespace posture
