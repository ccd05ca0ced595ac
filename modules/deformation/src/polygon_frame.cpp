// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "polygon_frame.h"

#include <cmath>

namespace posture {

using Eigen::Matrix3d;
using Eigen::Vector3d;

PolygonFrame::PolygonFrame(const std::vector<Vector3d>& corners) {
  const auto count = static_cast<double>(corners.size());
  for (const Vector3d& p : corners) centroid += p / count;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Vector3d from = corners[k] - centroid;
    const Vector3d twice = from.cross(corners[(k + 1) % corners.size()] - centroid);
    area += 0.5 * twice;
    fan_area += 0.5 * twice.norm();
    radius += from.squaredNorm() / count;
  }
  radius = std::sqrt(radius);
}

Matrix3d polygonAxes(const PolygonFrame& frame, const std::vector<Vector3d>& corners) {
  const Vector3d n = frame.normal();
  Vector3d tangent = Vector3d::Zero();
  for (const Vector3d& p : corners) {
    const Vector3d from = p - frame.centroid, across = from - n.dot(from) * n;
    if (across.norm() > FARTHER_BEYOND_ROUNDING * tangent.norm()) tangent = across;
  }
  tangent.normalize();
  Matrix3d axes;
  axes << tangent, n.cross(tangent), n;
  return axes;
}

}  // namespace posture
