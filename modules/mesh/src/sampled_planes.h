// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/types.h>

#include <optional>
#include <vector>

namespace posture {

/// Points of a surface, spread evenly over its area. Lengths are in square roots of that.
struct AreaSamples {
  static constexpr int MOST = 4096;  ///< and hardly fewer

  explicit AreaSamples(const TriangleMesh& mesh);

  Points points, normals;
};

/// A plane as thick as a scanner makes it.
struct Plane {
  Eigen::RowVector3d normal = Eigen::RowVector3d::Zero();
  double offset = 0;
  double reach = 0;  ///< what lies as far from it is in it

  double height(const Eigen::RowVector3d& point) const { return point.dot(normal) - offset; }

  /// Whether a sample is in it, and looks along its normal.
  bool holds(const AreaSamples& samples, int i) const;
};

/// The plane that holds most of some samples, as thick as they make it; none: it holds few.
std::optional<Plane> largestPlane(const AreaSamples& samples, const std::vector<int>& among);

}  // namespace posture
