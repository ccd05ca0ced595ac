// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/point_cloud.h>

#include <Eigen/Geometry>

namespace posture {

/// A cloud's finite points and their normals in a working frame, without those more than ten times
/// the cloud's size away from it.
struct LocalCloud {
  Points points;
  Points normals;                         ///< n x 3, zero where unknown; or 0 x 3
  std::optional<Eigen::Vector3d> sensor;  ///< where it stood
};

/// A frame that suits PCL, which computes in single precision and whose defaults are lengths: the
/// target's mean is the origin and its size a given length. The same for both sides, so it aligns
/// nothing.
class WorkingFrame {
 public:
  /// \param size  the diagonal of the box that holds the middle 98 % of the target's points along
  ///        each axis: outliers do not count.
  /// \throws InputError  fewer than 10 finite points, far ones aside, or all at one place.
  WorkingFrame(const Points& target, double size);

  /// \throws InputError  fewer than 10 finite points, far ones aside.
  LocalCloud local(const PointCloud& cloud) const;

  /// A motion found in this frame as one in the frame of the clouds.
  Eigen::Isometry3d given(const Eigen::Matrix4d& motion) const;

 private:
  Eigen::Vector3d center_;
  double unit_;
};

}  // namespace posture
