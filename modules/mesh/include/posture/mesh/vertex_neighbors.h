// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/types.h>

#include <vector>

namespace posture {

/// For each vertex of any mesh those it is joined to by an edge, in increasing order.
class VertexNeighbors {
 public:
  VertexNeighbors(const Faces& faces, int vertex_count);

  /// For each vertex the others that one or two edges lead to, in increasing order. Through a
  /// vertex that has more than 100 neighbours no two edges lead, only one to it.
  VertexNeighbors withinTwoEdges() const;

  const int* begin(int v) const { return neighbors_.data() + first_[v]; }
  const int* end(int v) const { return neighbors_.data() + first_[v + 1]; }

 private:
  VertexNeighbors() = default;

  std::vector<int> first_;  // n + 1
  std::vector<int> neighbors_;
};

/// The faces at each vertex, in increasing order.
class VertexFaces {
 public:
  VertexFaces(const Faces& faces, int vertex_count);

  const int* begin(int v) const { return faces_.data() + first_[v]; }
  const int* end(int v) const { return faces_.data() + first_[v + 1]; }

 private:
  std::vector<int> first_;  // n + 1
  std::vector<int> faces_;
};

}  // namespace posture
