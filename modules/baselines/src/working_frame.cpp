// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "working_frame.h"

#include <posture/core/computable.h>
#include <posture/core/error.h>
#include <posture/core/finite_rows.h>
#include <posture/mesh/nearest_rotation.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <tuple>
#include <utility>
#include <vector>

namespace posture {
namespace {

constexpr int FEWEST_POINTS = 10;

void requireEnough(const std::vector<int>& rows) {
  if (rows.size() < FEWEST_POINTS)
    throw InputError(std::to_string(rows.size()) + " points, expected " +
                     std::to_string(FEWEST_POINTS) + " or more");
}

/// What holds the middle 98 % of the numbers, all but one a side of few.
/// \pre  three at least
std::pair<double, double> middle(Vector values) {
  std::sort(values.data(), values.data() + values.size());
  const Eigen::Index off = std::max<Eigen::Index>(1, values.size() / 100);
  return {values[off], values[values.size() - 1 - off]};
}

/// Of the middle 98 % along each axis: one point thrown far out is no size.
Eigen::AlignedBox3d boxOf(const Points& points) {
  Eigen::AlignedBox3d box(Eigen::Vector3d::Zero());
  for (int k = 0; k < 3; ++k) std::tie(box.min()[k], box.max()[k]) = middle(points.col(k));
  return box;
}

/// Finite points but for those more than ten sizes off: PCL's grids would span these, too, and from
/// 26 sizes on, with cells of a fiftieth, have more cells than it can count.
std::vector<int> bodyRows(const Points& points) {
  constexpr double FAR = 10;
  std::vector<int> rows = finiteRows(points);
  requireEnough(rows);
  const Eigen::AlignedBox3d box = boxOf(points(rows, Eigen::all));
  const double farthest = FAR * box.diagonal().norm();
  const auto isFar = [&](int row) {
    return (points.row(row).transpose() - box.center()).norm() > farthest;
  };
  if (farthest > 0) rows.erase(std::remove_if(rows.begin(), rows.end(), isFar), rows.end());
  requireEnough(rows);
  return rows;
}

}  // namespace

WorkingFrame::WorkingFrame(const Points& target, double size) {
  const Points points = target(bodyRows(target), Eigen::all);
  center_ = points.colwise().mean();
  const Eigen::Vector3d box = boxOf(points).sizes();
  requireNotTooLarge(center_.cwiseAbs().maxCoeff() + box.maxCoeff());
  requireNotTooSmall(box.maxCoeff());
  unit_ = box.norm() / size;
  if (!(unit_ > 0)) throw InputError("all points at one place");
}

LocalCloud WorkingFrame::local(const PointCloud& cloud) const {
  const std::vector<int> rows = bodyRows(cloud.points);
  LocalCloud local;
  local.points = (cloud.points(rows, Eigen::all).rowwise() - center_.transpose()) / unit_;
  constexpr double FARTHEST = 1e15;  // PCL squares distances in single precision
  if (!(local.points.cwiseAbs().maxCoeff() < FARTHEST))
    throw InputError("a point too far off to compute with");
  if (cloud.normals.rows() > 0) local.normals = cloud.normals(rows, Eigen::all);
  if (cloud.sensor) local.sensor = (*cloud.sensor - center_) / unit_;
  return local;
}

Eigen::Isometry3d WorkingFrame::given(const Eigen::Matrix4d& motion) const {
  Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
  result.linear() = nearestRotation(motion.topLeftCorner<3, 3>());
  result.translation() =
      unit_ * motion.topRightCorner<3, 1>() + center_ - result.linear() * center_;
  return result;
}

}  // namespace posture
