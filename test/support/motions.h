// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/types.h>

#include <Eigen/Geometry>

namespace posture::test {

/// A turn about a skew axis, and a shift.
inline Eigen::Isometry3d motion(double angle) {
  return Eigen::Translation3d(1, -2, 3) *
         Eigen::AngleAxisd(angle, Eigen::Vector3d(1, 2, -1).normalized());
}

/// Far away, turned, and in another unit: seven times as large.
inline Eigen::Affine3d similarity() {
  return Eigen::Translation3d(100, -20, 3) *
         Eigen::AngleAxisd(2, Eigen::Vector3d(1, 2, -1).normalized()) * Eigen::Scaling(7.0);
}

inline Points moved(const Points& points, const Eigen::Affine3d& by) {
  return (by * points.transpose()).transpose();
}

inline TriangleMesh moved(const TriangleMesh& mesh, const Eigen::Affine3d& by) {
  return {moved(mesh.vertices, by), mesh.faces};
}

}  // namespace posture::test
