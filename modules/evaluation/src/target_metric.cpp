// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/error.h>
#include <posture/core/parallel.h>
#include <posture/evaluation/target_metric.h>
#include <posture/mesh/areas.h>
#include <posture/mesh/denoise.h>
#include <posture/mesh/position_of.h>
#include <posture/mesh/require_mesh.h>
#include <posture/mesh/seams.h>
#include <posture/mesh/spikes.h>

#include <algorithm>
#include <numeric>
#include <string>
#include <utility>

namespace posture {
namespace {

/// Breadth-first search over a mesh's edges, with memory that is reused from one start to the next.
class EdgeSearch {
 public:
  EdgeSearch(const VertexNeighbors& neighbors, Eigen::Index vertex_count)
      : neighbors_(neighbors), steps_(vertex_count, -1) {}

  /// Runs until all of `goals` are reached (each may be named more than once).
  void run(int start, const std::vector<int>& goals) {
    for (int v : queue_) steps_[v] = -1;
    queue_.assign(1, start);
    steps_[start] = 0;
    std::size_t open_goal = 0;
    for (std::size_t next = 0; next < queue_.size(); ++next) {
      while (open_goal < goals.size() && steps_[goals[open_goal]] >= 0) ++open_goal;
      if (open_goal == goals.size()) return;
      const int v = queue_[next];
      for (const int* w = neighbors_.begin(v); w != neighbors_.end(v); ++w) {
        if (steps_[*w] >= 0) continue;
        steps_[*w] = steps_[v] + 1;
        queue_.push_back(*w);
      }
    }
  }

  int steps(int v) const { return steps_[v]; }

 private:
  const VertexNeighbors& neighbors_;
  std::vector<int> steps_;  // -1: not reached
  std::vector<int> queue_;
};

/// body(begin, end) for blocks of 0 .. count - 1, in parallel; memory of the mesh's size is reused
/// within a block, so there are no more of them than keep some threads busy.
template <class Body>
void parallelBlocks(std::size_t count, const Body& body) {
  constexpr std::size_t LEAST = 16, MOST_BLOCKS = 256;
  const std::size_t size = std::max(LEAST, (count + MOST_BLOCKS - 1) / MOST_BLOCKS);
  parallelFor(static_cast<int>((count + size - 1) / size), [&](int block) {
    const std::size_t begin = block * size;
    body(begin, std::min(count, begin + size));
  });
}

/// As denoise(), but for noise: it is measured on.
TriangleMesh withoutDefects(TriangleMesh mesh) {
  requireMesh(mesh);
  closeSeams(mesh);
  setSpikesBack(mesh);
  return mesh;
}

}  // namespace

TargetMetric::TargetMetric(TriangleMesh target)
    : target_(withoutDefects(std::move(target))),
      surface_(cleanMesh(target_)),
      marching_(surface_.mesh),
      neighbors_(surface_.mesh.faces, static_cast<int>(surface_.mesh.vertices.rows())),
      root_area_(posture::rootArea(surface_.mesh)) {
  if (!(root_area_ > 0)) throw InputError("has no area");
}

void TargetMetric::check(const std::vector<Route>& routes) const {
  for (const Route& route : routes) {
    require(route.from >= 0 && route.from < vertexCount(),
            "route from vertex " + std::to_string(route.from) + ", the target has " +
                std::to_string(vertexCount()));
    require(route.to.vertex >= 0 && route.to.vertex < vertexCount(),
            "route to vertex " + std::to_string(route.to.vertex) + ", the target has " +
                std::to_string(vertexCount()));
    require(route.to.face < faceCount(),
            "route to face " + std::to_string(route.to.face) + ", the target has " +
                std::to_string(faceCount()));
  }
}

std::vector<std::vector<int>> TargetMetric::groupByStart(const std::vector<Route>& routes) const {
  const auto start = [&](int r) { return surface_.clean_vertex[routes[r].from]; };
  std::vector<int> order(routes.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return start(a) < start(b); });
  std::vector<std::vector<int>> groups;
  for (int r : order) {
    if (groups.empty() || start(groups.back().front()) != start(r)) groups.emplace_back();
    groups.back().push_back(r);
  }
  return groups;
}

bool TargetMetric::samePlace(int a, int b) const {
  return a == b || (surface_.clean_vertex[a] == surface_.clean_vertex[b] && surface_.isOnMain(a) &&
                    surface_.isOnMain(b));
}

double TargetMetric::lengthTo(int from, int to, const GeodesicField& field) const {
  if (from == to) return 0;
  return surface_.offset[from] + field.distance[surface_.clean_vertex[to]] + surface_.offset[to];
}

double TargetMetric::lengthTo(int from, const SurfacePoint& to, const GeodesicField& field) const {
  if (to.face < 0) return lengthTo(from, to.vertex, field);
  const Eigen::RowVector3i corners = target_.faces.row(to.face);
  for (int corner : corners)
    if (samePlace(from, corner))  // within one face the way is straight
      return (positionOf(target_, to) - target_.vertices.row(from)).norm();
  double length = 0;
  for (int k = 0; k < 3; ++k)
    if (to.barycentric[k] != 0) length += to.barycentric[k] * lengthTo(from, corners[k], field);
  return length;
}

void TargetMetric::appendGoals(const SurfacePoint& to, std::vector<int>& goals) const {
  if (to.face < 0) {
    goals.push_back(surface_.clean_vertex[to.vertex]);
    return;
  }
  for (int k = 0; k < 3; ++k)
    if (to.barycentric[k] != 0) goals.push_back(surface_.clean_vertex[target_.faces(to.face, k)]);
}

RouteLengths TargetMetric::geodesics(const std::vector<Route>& routes) const {
  check(routes);
  const auto groups = groupByStart(routes);
  RouteLengths lengths;
  lengths.length.assign(routes.size(), 0.0);
  std::vector<std::int64_t> settled(groups.size(), 0);
  parallelBlocks(groups.size(), [&](std::size_t begin, std::size_t end) {
    GeodesicField field;
    std::vector<int> goals;
    for (std::size_t g = begin; g < end; ++g) {
      goals.clear();
      for (int r : groups[g]) appendGoals(routes[r].to, goals);
      marching_.marchUntil(surface_.clean_vertex[routes[groups[g].front()].from], goals, field);
      for (int r : groups[g]) lengths.length[r] = lengthTo(routes[r].from, routes[r].to, field);
      settled[g] = static_cast<std::int64_t>(field.order.size());
    }
  });
  lengths.settled_vertices = std::accumulate(settled.begin(), settled.end(), std::int64_t{0});
  return lengths;
}

std::vector<int> TargetMetric::edgeCounts(const std::vector<Route>& routes) const {
  check(routes);
  const auto groups = groupByStart(routes);
  std::vector<int> counts(routes.size(), 0);
  parallelBlocks(groups.size(), [&](std::size_t begin, std::size_t end) {
    EdgeSearch search(neighbors_, surface_.mesh.vertices.rows());
    std::vector<int> goals;
    for (std::size_t g = begin; g < end; ++g) {
      goals.clear();
      for (int r : groups[g]) goals.push_back(surface_.clean_vertex[routes[r].to.vertex]);
      search.run(surface_.clean_vertex[routes[groups[g].front()].from], goals);
      for (int r : groups[g]) {
        const int from = routes[r].from, to = routes[r].to.vertex;
        if (from == to) continue;
        counts[r] = search.steps(surface_.clean_vertex[to]) + !surface_.isOnMain(from) +
                    !surface_.isOnMain(to);
      }
    }
  });
  return counts;
}

}  // namespace posture
