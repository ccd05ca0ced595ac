// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/types.h>
#include <posture/mesh/vertex_neighbors.h>

#include <vector>

namespace posture {

class ShortestWays;

/// Shortest ways along the edges of a mesh, which must outlive this (Dijkstra 1959).
class EdgePaths {
 public:
  explicit EdgePaths(const TriangleMesh& mesh);

  /// n lengths from any of some vertices; infinity where there is no way.
  Vector lengths(const std::vector<int>& from) const;

  /// Whether ways of at most some length lead from a vertex to all of some others. Looks no farther
  /// than it must.
  bool reachesAll(int from, std::vector<int> to, double most) const;

  /// The vertices on the way between two, both included; empty where there is none.
  std::vector<int> shortest(int from, int to) const;

 private:
  template <class Arrive>
  ShortestWays search(const std::vector<int>& from, const Arrive& arrive) const;
  double length(int v, int w) const;

  const TriangleMesh& mesh_;
  VertexNeighbors neighbors_;
};

}  // namespace posture
