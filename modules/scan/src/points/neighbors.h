// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/types.h>

#include <memory>
#include <vector>

namespace posture {

/// For each of some points its nearest others, near ones first; rows are padded with -1.
using NeighborTable = Eigen::Matrix<int, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Several nearest neighbours, and all within a radius, in a working frame (PCL's kd-tree).
class NeighborSearch {
 public:
  /// \pre  points not empty, finite, of extent about one.
  explicit NeighborSearch(const Points& points);
  ~NeighborSearch();
  NeighborSearch(NeighborSearch&&) noexcept;
  NeighborSearch& operator=(NeighborSearch&&) noexcept;

  /// The `count` points nearest to point `i`, itself not among them. May be called from several
  /// threads, as all here.
  std::vector<int> nearest(int i, int count) const;

  /// The points closer than `radius` to a place.
  std::vector<int> within(const Eigen::Vector3d& place, double radius) const;

  /// n x count.
  NeighborTable table(int count) const;

 private:
  struct Tree;
  std::unique_ptr<const Tree> tree_;
};

/// Entries of a row before the padding.
int neighborCount(const NeighborTable& table, int row);

}  // namespace posture
