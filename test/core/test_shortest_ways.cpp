// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/rng.h>
#include <posture/core/shortest_ways.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <utility>
#include <vector>

namespace posture {
namespace {

constexpr double FAR = std::numeric_limits<double>::infinity();

/// Edges that lead one way, of small whole lengths, so that many ways are as long.
struct Graph {
  struct Edge {
    int from, to, length;
  };

  Graph(int n, int edges, std::uint64_t seed) : nodes(n) {
    Rng rng(seed);
    for (int e = 0; e < edges; ++e) all.push_back({rng.below(n), rng.below(n), rng.below(4)});
  }

  /// Bellman and Ford.
  std::vector<double> distances(const std::vector<int>& from) const {
    std::vector<double> distance(nodes, FAR);
    for (int v : from) distance[v] = 0;
    for (int round = 0; round < nodes; ++round)
      for (const Edge& e : all)
        distance[e.to] = std::min(distance[e.to], distance[e.from] + e.length);
    return distance;
  }

  auto edges() const {
    return [this](int v, const auto& step) {
      for (const Edge& e : all)
        if (e.from == v) step(e.to, e.length);
    };
  }

  int nodes;
  std::vector<Edge> all;
};

TEST(ShortestWays, areAsLongAsByRelaxingEveryEdge) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Graph graph(40, 90, seed);
    ShortestWays ways(graph.nodes);
    // One for all searches: none knows of the one before.
    for (const std::vector<int>& from : {std::vector<int>{3}, {7, 20, 7}, {0}}) {
      std::vector<std::pair<double, int>> arrivals;
      ways.search(from, graph.edges(), [&](int v) {
        arrivals.emplace_back(ways.distance(v), v);
        return true;
      });
      const std::vector<double> expected = graph.distances(from);
      EXPECT_EQ(ways.distances(), expected);
      EXPECT_EQ(arrivals.size(), graph.nodes - std::count(expected.begin(), expected.end(), FAR));
      for (const auto& [distance, v] : arrivals) {
        const int u = ways.before(v);
        if (u < 0) {
          EXPECT_EQ(std::count(from.begin(), from.end(), v) > 0, true);
          continue;
        }
        EXPECT_TRUE(std::any_of(graph.all.begin(), graph.all.end(), [&](const Graph::Edge& e) {
          return e.from == u && e.to == v && ways.distance(u) + e.length == distance;
        }));
      }
    }
  }
}

TEST(ShortestWays, arriveAtTheNearestFirstAndOfSeveralAtTheLeast) {
  // All edges of a row of nodes to each other, as long as they are apart.
  constexpr int N = 9;
  const auto edges = [](int v, const auto& step) {
    for (int w = N - 1; w >= 0; --w)
      if (w != v) step(w, std::abs(w - v));
  };
  ShortestWays ways(N);
  std::vector<int> order;
  ways.search({4}, edges, [&](int v) {
    order.push_back(v);
    return true;
  });
  EXPECT_EQ(order, (std::vector<int>{4, 3, 5, 2, 6, 1, 7, 0, 8}));
  EXPECT_EQ(ways.before(0), 4);
}

TEST(ShortestWays, endWhereTheyAreTold) {
  const auto row = [](int v, const auto& step) {
    if (v < 99) step(v + 1, 1);
  };
  ShortestWays ways(100);
  int arrivals = 0;
  ways.search({0}, row, [&](int v) {
    ++arrivals;
    return v != 5;
  });
  EXPECT_EQ(arrivals, 6);
  EXPECT_EQ(ways.distance(5), 5);
  EXPECT_EQ(ways.distance(6), FAR);
  ways.search({50}, row, [&](int v) { return v != 51; });
  EXPECT_EQ(ways.distance(5), FAR);
  EXPECT_EQ(ways.before(5), -1);
  ways.search({}, row, [](int) { return true; });
  EXPECT_EQ(ways.distance(50), FAR);
}

}  // namespace
}  // namespace posture
