// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace posture {

/// Sums over the places of a body, by area: its mass, centroid and inertia.
class Mass {
 public:
  void add(const Eigen::Vector3d& place, double area);
  void add(const Mass& other);

  double area() const { return area_; }
  Eigen::Vector3d centroid() const { return first_ / area_; }
  Eigen::Matrix3d inertia() const;  ///< tensor about the centroid

 private:
  double area_ = 0;
  Eigen::Vector3d first_ = Eigen::Vector3d::Zero();
  Eigen::Matrix3d second_ = Eigen::Matrix3d::Zero();
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

/// By how much two rigid bodies turn against each other at `joint`, in radians, where `cost` is the
/// sum of squared distances, by area, that is left when they move as one. Small turns about the
/// axis that costs most: a twist of a limb about its length, which registrations do not see well,
/// counts for little.
double turnOf(const Mass& a, const Mass& b, const Eigen::Vector3d& joint, double cost);

}  // namespace posture
