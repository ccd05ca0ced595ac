// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/types.h>

#include <memory>
#include <vector>

namespace posture {

/// Nearest neighbours in space (PCL's kd-tree). Coordinates are centred and scaled first: PCL
/// computes in single precision, and scans come far from the origin and in any unit.
class PointIndex {
 public:
  struct Neighbor {
    int index;
    double distance;  ///< in the unit of the points, not squared
  };

  /// \throws std::invalid_argument  no points; one is not finite.
  explicit PointIndex(const Points& points);
  ~PointIndex();
  PointIndex(PointIndex&&) noexcept;
  PointIndex& operator=(PointIndex&&) noexcept;

  /// May be called from several threads. From farther than a thousand times the extent of the
  /// points, which is nearest and how far is good to half a percent.
  /// \throws std::invalid_argument  the query is not finite; as all here.
  Neighbor nearest(const Eigen::Vector3d& query) const;

  /// The nearest \p count points (all, where there are fewer), near ones first; likewise.
  std::vector<Neighbor> nearest(const Eigen::Vector3d& query, int count) const;

  /// All points closer than \p radius, in increasing order; by rounding perhaps some beyond,
  /// from far off (above) by half a percent of the way.
  std::vector<int> within(const Eigen::Vector3d& query, double radius) const;

 private:
  struct Tree;
  std::unique_ptr<const Tree> tree_;
};

}  // namespace posture
