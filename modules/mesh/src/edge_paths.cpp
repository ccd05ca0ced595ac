// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/shortest_ways.h>
#include <posture/mesh/edge_paths.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <queue>
#include <unordered_map>
#include <utility>

namespace posture {

EdgePaths::EdgePaths(const TriangleMesh& mesh)
    : mesh_(mesh), neighbors_(mesh.faces, static_cast<int>(mesh.vertices.rows())) {}

double EdgePaths::length(int v, int w) const {
  return (mesh_.vertices.row(v) - mesh_.vertices.row(w)).norm();
}

template <class Arrive>
ShortestWays EdgePaths::search(const std::vector<int>& from, const Arrive& arrive) const {
  ShortestWays ways(static_cast<int>(mesh_.vertices.rows()));
  const auto forEachNext = [&](int v, const auto& step) {
    for (const int* w = neighbors_.begin(v); w != neighbors_.end(v); ++w) step(*w, length(v, *w));
  };
  ways.search(from, forEachNext, arrive);
  return ways;
}

Vector EdgePaths::lengths(const std::vector<int>& from) const {
  const ShortestWays ways = search(from, [](int) { return true; });
  return Eigen::Map<const Vector>(ways.distances().data(), mesh_.vertices.rows());
}

bool EdgePaths::reachesAll(int from, std::vector<int> to, double most) const {
  // Of what is reached alone: asked at each of many places, vectors of all vertices would take
  // longer than the ways.
  std::unordered_map<int, double> distance{{from, 0}};
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> front;
  front.emplace(0, from);
  while (!front.empty() && !to.empty()) {
    const auto [reached, v] = front.top();
    front.pop();
    if (reached > distance[v]) continue;
    to.erase(std::remove(to.begin(), to.end(), v), to.end());
    for (const int* w = neighbors_.begin(v); w != neighbors_.end(v); ++w) {
      const double reach = reached + length(v, *w);
      if (reach > most) continue;
      const auto [known, is_new] = distance.try_emplace(*w, reach);
      if (!is_new && reach >= known->second) continue;
      known->second = reach;
      front.emplace(reach, *w);
    }
  }
  return to.empty();
}

std::vector<int> EdgePaths::shortest(int from, int to) const {
  const ShortestWays ways = search({from}, [&](int v) { return v != to; });
  if (std::isinf(ways.distance(to))) return {};
  std::vector<int> path{to};
  while (path.back() != from) path.push_back(ways.before(path.back()));
  std::reverse(path.begin(), path.end());
  return path;
}

}  // namespace posture
