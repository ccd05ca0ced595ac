// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "working_frame.h"

#include <posture/core/computable.h>
#include <posture/core/error.h>
#include <posture/core/finite_rows.h>
#include <posture/mesh/nearest_rotation.h>

#include <algorithm>
#include <vector>

namespace posture {
namespace {

constexpr int FEWEST_POINTS = 10;

std::vector<int> enoughRows(const Points& points) {
  std::vector<int> rows = finiteRows(points);
  if (rows.size() < FEWEST_POINTS)
    throw InputError(std::to_string(rows.size()) + " points, expected " +
                     std::to_string(FEWEST_POINTS) + " or more");
  return rows;
}

/// The length that holds the middle 98 % of the numbers.
double spread(Vector values) {
  std::sort(values.data(), values.data() + values.size());
  const Eigen::Index off = values.size() / 100;
  return values[values.size() - 1 - off] - values[off];
}

}  // namespace

WorkingFrame::WorkingFrame(const Points& target, double size) {
  const Points points = target(enoughRows(target), Eigen::all);
  center_ = points.colwise().mean();
  const Eigen::Vector3d box(spread(points.col(0)), spread(points.col(1)), spread(points.col(2)));
  requireNotTooLarge(center_.cwiseAbs().maxCoeff() + box.maxCoeff());
  requireNotTooSmall(box.maxCoeff());
  unit_ = box.norm() / size;
  if (!(unit_ > 0)) throw InputError("all points at one place");
}

LocalCloud WorkingFrame::local(const PointCloud& cloud) const {
  const std::vector<int> rows = enoughRows(cloud.points);
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
