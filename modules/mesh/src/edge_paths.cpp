// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/mesh/edge_paths.h>

#include <algorithm>
#include <functional>
#include <queue>
#include <unordered_map>
#include <utility>

namespace posture {
namespace {

constexpr double FAR = std::numeric_limits<double>::infinity();

/// Vertices by their distance, the nearest first.
using Entry = std::pair<double, int>;
using Front = std::priority_queue<Entry, std::vector<Entry>, std::greater<>>;

}  // namespace

struct EdgePaths::Ways {
  Vector distance;
  std::vector<int> before;
};

EdgePaths::EdgePaths(const TriangleMesh& mesh)
    : mesh_(mesh), neighbors_(mesh.faces, static_cast<int>(mesh.vertices.rows())) {}

double EdgePaths::length(int v, int w) const {
  return (mesh_.vertices.row(v) - mesh_.vertices.row(w)).norm();
}

/// Calls arrival(v) for each vertex in the order of its distance, until that is false.
template <class Arrival>
EdgePaths::Ways EdgePaths::search(const std::vector<int>& from, const Arrival& arrival) const {
  Front front;
  const auto n = mesh_.vertices.rows();
  Ways ways{Vector::Constant(n, FAR), std::vector<int>(n, -1)};
  for (int v : from) {
    ways.distance[v] = 0;
    front.emplace(0, v);
  }
  while (!front.empty()) {
    const auto [reached, v] = front.top();
    front.pop();
    if (reached > ways.distance[v]) continue;
    if (!arrival(v)) break;
    for (const int* w = neighbors_.begin(v); w != neighbors_.end(v); ++w) {
      const double reach = reached + length(v, *w);
      if (reach >= ways.distance[*w]) continue;
      ways.distance[*w] = reach;
      ways.before[*w] = v;
      front.emplace(reach, *w);
    }
  }
  return ways;
}

Vector EdgePaths::lengths(const std::vector<int>& from) const {
  return search(from, [](int) { return true; }).distance;
}

bool EdgePaths::reachesAll(int from, std::vector<int> to, double most) const {
  // Of what is reached alone: asked at each of many places, vectors of all vertices would take
  // longer than the ways.
  std::unordered_map<int, double> distance{{from, 0}};
  Front front;
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
  const Ways ways = search({from}, [&](int v) { return v != to; });
  if (ways.distance[to] == FAR) return {};
  std::vector<int> path{to};
  while (path.back() != from) path.push_back(ways.before[path.back()]);
  std::reverse(path.begin(), path.end());
  return path;
}

}  // namespace posture
