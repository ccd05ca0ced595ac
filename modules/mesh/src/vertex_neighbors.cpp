// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/mesh/edges.h>
#include <posture/mesh/vertex_neighbors.h>

#include <algorithm>
#include <cstddef>
#include <iterator>

namespace posture {

VertexNeighbors::VertexNeighbors(const Faces& faces, int vertex_count)
    : first_(vertex_count + 1, 0) {
  const std::vector<Edge> edges = meshEdges(faces);
  for (const Edge& e : edges) {
    ++first_[e.first + 1];
    ++first_[e.second + 1];
  }
  for (int v = 0; v < vertex_count; ++v) first_[v + 1] += first_[v];
  neighbors_.resize(2 * edges.size());
  std::vector<int> next(first_.begin(), first_.end() - 1);
  // Sorted edges give each vertex first its lower neighbours, then its higher ones, in order.
  for (const Edge& e : edges) neighbors_[next[e.second]++] = e.first;
  for (const Edge& e : edges) neighbors_[next[e.first]++] = e.second;
}

VertexNeighbors VertexNeighbors::withinTwoEdges() const {
  // Every vertex at the rim of a fan would have all others.
  constexpr std::ptrdiff_t MOST_NEIGHBORS = 100;
  const int n = static_cast<int>(first_.size()) - 1;
  VertexNeighbors two;
  two.first_.assign(1, 0);
  std::vector<int> near;
  for (int v = 0; v < n; ++v) {
    near.assign(begin(v), end(v));
    for (const int* w = begin(v); w != end(v); ++w)
      if (end(*w) - begin(*w) <= MOST_NEIGHBORS) near.insert(near.end(), begin(*w), end(*w));
    std::sort(near.begin(), near.end());
    near.erase(std::unique(near.begin(), near.end()), near.end());
    std::remove_copy(near.begin(), near.end(), std::back_inserter(two.neighbors_), v);
    two.first_.push_back(static_cast<int>(two.neighbors_.size()));
  }
  return two;
}

VertexFaces::VertexFaces(const Faces& faces, int vertex_count)
    : first_(vertex_count + 1, 0), faces_(faces.size()) {
  for (const int v : faces.reshaped()) ++first_[v + 1];
  for (int v = 0; v < vertex_count; ++v) first_[v + 1] += first_[v];
  std::vector<int> next(first_.begin(), first_.end() - 1);
  for (int f = 0; f < faces.rows(); ++f)
    for (int k = 0; k < 3; ++k) faces_[next[faces(f, k)]++] = f;
}

}  // namespace posture
