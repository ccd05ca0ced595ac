// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

namespace posture {

using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Vector6 = Eigen::Matrix<double, 6, 1>;  ///< a small motion: a turn, then a shift

/// What it costs to move a body off the surface it lies on: a quadratic form of small motions.
/// Distance along the surface may count less than distance across it.
class Stiffness {
 public:
  void add(const Eigen::Vector3d& place, const Eigen::Vector3d& normal, double area);
  void add(const Stiffness& other);

  /// Of motions given by a turn about `place`, and the shift of what is there.
  Matrix6 about(const Eigen::Vector3d& place, double along) const;

 private:
  Matrix6 across_ = Matrix6::Zero(), whole_ = Matrix6::Zero();
};

/// Where two sets of faces touch.
class Border {
 public:
  void add(const Eigen::Vector3d& from, const Eigen::Vector3d& to);
  void add(const Border& other);

  Eigen::Vector3d middle() const { return sum_ / length_; }

 private:
  double length_ = 0;
  Eigen::Vector3d sum_ = Eigen::Vector3d::Zero();  // of middles, by length
};

/// Two bodies that touch: what it costs to move them as one, where each would rather move by a
/// motion of its own.
class Joint {
 public:
  /// \param a, b   the bodies' stiffness about `place`.
  Joint(const Eigen::Vector3d& place, const Matrix6& a, const Matrix6& b);

  /// Their squared distances from where they want to be, by area, when both move by the one motion
  /// that suits them best.
  double cost(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b) const;

  /// By how much they turn against each other where moving as one costs so much, in radians. Small
  /// turns about the axis that costs most: a twist of a limb about its length, which registrations
  /// do not see well, counts for little.
  double turn(double cost) const;

 private:
  Eigen::Vector3d place_;
  Matrix6 between_;
};

}  // namespace posture
