// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/types.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace posture {

/// A place on a triangle mesh: a vertex, in a map the one that fits best and mostly the nearest,
/// and a face with barycentric coordinates.
struct SurfacePoint {
  int vertex = -1;  ///< -1: no place at all; the other members then mean nothing
  int face = -1;    ///< -1: the vertex belongs to no face
  Eigen::Vector3d barycentric = Eigen::Vector3d::Zero();  ///< >= 0, sum 1
};

/// How many have a place at all.
inline long mappedCount(const std::vector<SurfacePoint>& places) {
  return std::count_if(
      places.begin(), places.end(), [](const SurfacePoint& place) { return place.vertex >= 0; });
}

/// Where each vertex of the source lies on the target, both numbered as they were given.
struct Correspondence {
  std::vector<SurfacePoint> on_target;  ///< n, one per source vertex
  Vector confidence;                    ///< n, in [0, 1]; 0 where there is no counterpart
};

/// Leaves a source vertex without a counterpart.
inline void dropRow(Correspondence& map, std::size_t row) {
  map.on_target[row] = {};
  map.confidence[static_cast<Eigen::Index>(row)] = 0;
}

/// The same of those that are marked, and of those whose place is marked on the target.
/// \param here, there  one mark a vertex; empty: none is.
inline void dropRows(const std::vector<char>& here,
                     const std::vector<char>& there,
                     Correspondence& map) {
  const auto isMarked = [](const std::vector<char>& marks, std::size_t v) {
    return v < marks.size() && marks[v] != 0;
  };
  for (std::size_t v = 0; v < map.on_target.size(); ++v) {
    const int at = map.on_target[v].vertex;
    if (isMarked(here, v) || (at >= 0 && isMarked(there, static_cast<std::size_t>(at))))
      dropRow(map, v);
  }
}

/// A known pair of a source and a target vertex, 0-based.
struct VertexPair {
  int source = 0;
  int target = 0;
};

}  // namespace posture
