// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/types.h>

#include <memory>
#include <vector>

namespace posture {

/// Geodesic distances on a mesh from those vertices that they are asked from: marched at the first
/// time, kept for the next.
///
/// const members may be called from several threads.
class DistanceRows {
 public:
  explicit DistanceRows(const TriangleMesh& mesh);
  ~DistanceRows();
  DistanceRows(DistanceRows&&) noexcept;
  DistanceRows& operator=(DistanceRows&&) noexcept;

  /// Distances to every vertex, as FastMarching::march() has them.
  /// \throws std::invalid_argument  no such vertex.
  const std::vector<double>& from(int source) const;

 private:
  struct Rows;
  std::unique_ptr<Rows> rows_;
};

}  // namespace posture
