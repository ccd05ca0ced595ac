// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/mesh/edge_paths.h>

#include <algorithm>
#include <functional>
#include <queue>
#include <utility>

namespace posture {
namespace {

constexpr double FAR = std::numeric_limits<double>::infinity();

}  // namespace

struct EdgePaths::Ways {
  Vector distance;
  std::vector<int> before;
};

EdgePaths::EdgePaths(const TriangleMesh& mesh)
    : mesh_(mesh), neighbors_(mesh.faces, static_cast<int>(mesh.vertices.rows())) {}

/// Calls arrival(v) for each vertex in the order of its distance, until that is false.
template <class Arrival>
EdgePaths::Ways EdgePaths::search(const std::vector<int>& from,
                                  double most,
                                  const Arrival& arrival) const {
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> front;
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
      const double reach = reached + (mesh_.vertices.row(v) - mesh_.vertices.row(*w)).norm();
      if (reach > most || reach >= ways.distance[*w]) continue;
      ways.distance[*w] = reach;
      ways.before[*w] = v;
      front.emplace(reach, *w);
    }
  }
  return ways;
}

Vector EdgePaths::lengths(const std::vector<int>& from) const {
  return search(from, FAR, [](int) { return true; }).distance;
}

bool EdgePaths::reachesAll(int from, std::vector<int> to, double most) const {
  search({from}, most, [&](int v) {
    to.erase(std::remove(to.begin(), to.end(), v), to.end());
    return !to.empty();
  });
  return to.empty();
}

std::vector<int> EdgePaths::shortest(int from, int to) const {
  const Ways ways = search({from}, FAR, [&](int v) { return v != to; });
  if (ways.distance[to] == FAR) return {};
  std::vector<int> path{to};
  while (path.back() != from) path.push_back(ways.before[path.back()]);
  std::reverse(path.begin(), path.end());
  return path;
}

}  // namespace posture
