// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/shortest_ways.h>
#include <posture/core/unions.h>
#include <posture/mesh/half_edge_mesh.h>
#include <posture/mesh/handles.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace posture {

Handles::Handles(const TriangleMesh& mesh) : vertices_(static_cast<int>(mesh.vertices.rows())) {
  const HalfEdgeMesh edges(mesh.faces, vertices_);
  const int faces = static_cast<int>(mesh.faces.rows());
  regions_ = faces;
  std::vector<int> beyond(edges.halfEdgeCount(), -1);  // a rim: the number of its hole
  for (const std::vector<int>& loop : edges.boundaryLoops()) {
    for (int h : loop) beyond[h] = regions_;
    ++regions_;
  }
  for (int h = 0; h < edges.halfEdgeCount(); ++h) {
    const int twin = edges.twin(h);
    if (twin >= 0 && twin < h) continue;
    const int a = edges.origin(h), b = edges.target(h);
    sides_.push_back({a,
                      b,
                      h / 3,
                      twin >= 0 ? twin / 3 : beyond[h],
                      (mesh.vertices.row(a) - mesh.vertices.row(b)).norm()});
  }
  first_.assign(vertices_ + 1, 0);
  for (const Side& side : sides_) {
    ++first_[side.a + 1];
    ++first_[side.b + 1];
  }
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  steps_.resize(2 * sides_.size());
  std::vector<int> next(first_.begin(), first_.end() - 1);
  for (int s = 0; s < static_cast<int>(sides_.size()); ++s) {
    steps_[next[sides_[s].a]++] = {sides_[s].b, s};
    steps_[next[sides_[s].b]++] = {sides_[s].a, s};
  }
  // Euler and Poincare, over all connected parts.
  Unions parts(vertices_);
  int connected = edges.liveVertexCount();
  for (const Side& side : sides_) connected -= parts.join(side.a, side.b) ? 1 : 0;
  const int euler = edges.liveVertexCount() - static_cast<int>(sides_.size()) + regions_;
  count_ = (2 * connected - euler) / 2;
}

std::vector<std::vector<int>> Handles::loopsThrough(int base) const {
  if (count_ <= 0) return {};
  ShortestWays ways(vertices_);
  std::vector<int> depth(vertices_, 0);
  std::vector<char> in_tree(sides_.size(), 0);
  ways.search(
      {base},
      [&](int v, const auto& step) {
        for (int i = first_[v]; i < first_[v + 1]; ++i)
          step(steps_[i].vertex, sides_[steps_[i].side].length);
      },
      [&](int v) {
        const int before = ways.before(v);
        if (before < 0) return true;
        depth[v] = depth[before] + 1;
        const auto way = std::find_if(steps_.begin() + first_[v],
                                      steps_.begin() + first_[v + 1],
                                      [before](const Step& step) { return step.vertex == before; });
        in_tree[way->side] = 1;
        return true;
      });
  // The faces joined across the sides whose loops are longest; what then joins nothing is left.
  const auto length = [&](int s) {
    return ways.distance(sides_[s].a) + ways.distance(sides_[s].b) + sides_[s].length;
  };
  std::vector<int> order;
  for (int s = 0; s < static_cast<int>(sides_.size()); ++s)
    if (!in_tree[s] && std::isfinite(ways.distance(sides_[s].a))) order.push_back(s);
  std::vector<double> lengths(sides_.size());
  for (int s : order) lengths[s] = length(s);
  std::stable_sort(
      order.begin(), order.end(), [&](int s, int t) { return lengths[s] > lengths[t]; });
  Unions regions(regions_);
  std::vector<std::vector<int>> loops;
  for (int s : order) {
    if (regions.join(sides_[s].one, sides_[s].other)) continue;
    std::vector<int> there{sides_[s].a}, back{sides_[s].b};
    while (there.back() != back.back())
      if (depth[there.back()] >= depth[back.back()])
        there.push_back(ways.before(there.back()));
      else
        back.push_back(ways.before(back.back()));
    back.pop_back();
    std::reverse(there.begin(), there.end());
    there.insert(there.end(), back.begin(), back.end());
    loops.push_back(std::move(there));
  }
  std::reverse(loops.begin(), loops.end());
  return loops;
}

}  // namespace posture
