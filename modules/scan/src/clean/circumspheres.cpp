// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "clean/circumspheres.h"

#include <posture/core/parallel.h>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <limits>
#include <utility>

namespace posture {
namespace {

/// Towards the inside of the tetrahedron; not of unit length.
Eigen::RowVector3d inwardNormal(const Points& points, const std::array<int, 3>& face) {
  return (points.row(face[2]) - points.row(face[0]))
      .cross(points.row(face[1]) - points.row(face[0]));
}

/// From the first corner to the centre.
Eigen::RowVector3d toCenter(const Points& points, const std::array<int, 4>& corners) {
  Eigen::Matrix3d edges;
  Eigen::Vector3d squares;
  for (int k = 0; k < 3; ++k) {
    edges.row(k) = points.row(corners[k + 1]) - points.row(corners[0]);
    squares[k] = edges.row(k).squaredNorm() / 2;
  }
  const Eigen::Vector3d offset = edges.fullPivLu().solve(squares);
  return (offset.allFinite() ? offset : Eigen::Vector3d::Zero()).transpose();
}

}  // namespace

Circumspheres::Circumspheres(const Points& points, const Tetrahedra& tetrahedra)
    : points_(points), tetrahedra_(tetrahedra) {
  const int count = tetrahedra.size();
  infinite_.assign(count, -1);
  centers_.resize(count, 3);
  radii_.resize(count);
  forEach(count, [&](int t) {
    const std::array<int, 4>& corners = tetrahedra.corners[t];
    for (int k = 0; k < 4; ++k)
      if (corners[k] == points.rows()) infinite_[t] = k;
    if (infinite_[t] >= 0) {
      centers_.row(t) = inwardNormal(points, tetrahedra.face(t, infinite_[t])).normalized();
      radii_[t] = std::numeric_limits<double>::infinity();
    } else {
      const Eigen::RowVector3d offset = toCenter(points, corners);
      centers_.row(t) = points.row(corners[0]) + offset;
      radii_[t] = offset.norm();
    }
  });
}

Eigen::RowVector3d Circumspheres::direction(int corner, int t) const {
  if (isInfinite(t)) return centers_.row(t);
  return centers_.row(t) - points_.row(corner);
}

double Circumspheres::overlap(int s, int t) const {
  if (isInfinite(s) && isInfinite(t)) return centers_.row(s).dot(centers_.row(t));
  if (isInfinite(s)) std::swap(s, t);
  if (isInfinite(t)) {
    const int on_hull = tetrahedra_.corners[t][(infinite_[t] + 1) % 4];
    return centers_.row(t).dot(direction(on_hull, s)) / radii_[s];
  }
  const double apart = (centers_.row(s) - centers_.row(t)).squaredNorm();
  return (radii_[s] * radii_[s] + radii_[t] * radii_[t] - apart) / (2 * radii_[s] * radii_[t]);
}

double Circumspheres::faceCosine(int t, int k) const {
  if (isInfinite(t)) return 1;
  const std::array<int, 3> face = tetrahedra_.face(t, k);
  return inwardNormal(points_, face).normalized().dot(direction(face[0], t)) / radii_[t];
}

}  // namespace posture
