// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/error.h>
#include <posture/geodesic/fast_marching.h>

#include "bucket_queue.h"
#include "unfolding.h"
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace posture {
namespace {

constexpr double INFINITE = std::numeric_limits<double>::infinity();

/// A triangle (real, or unfolded across an obtuse corner) seen from one of the two vertices that
/// the front reaches first: that vertex lies at 0, `other` at (base, 0), `target` at (x, y), y > 0.
struct Wedge {
  int target;
  int other;
  float base;
  float x;
  float y;
  float side;  ///< from the vertex to `target`
};

/// How the front comes to a wedge's target.
struct Arrival {
  double distance;
  bool through_other;  ///< it crosses the base nearer to `other`
};

/// From both vertices of the base, reached at distances da and db.
Arrival arrival(const Wedge& w, double da, double db) {
  const Arrival along_side{da + w.side, false};
  // The virtual source at (sx, -depth): at distance da from 0 and db from (base, 0).
  const double sx = (da * da - db * db + double{w.base} * w.base) / (2 * double{w.base});
  const double depth_sq = da * da - sx * sx;
  if (!(depth_sq >= 0)) return along_side;
  const double depth = std::sqrt(depth_sq), rise = w.y + depth;
  const double crossing = sx + (w.x - sx) * depth / rise;
  if (!(crossing >= 0 && crossing <= w.base)) return along_side;
  return {std::sqrt((w.x - sx) * (w.x - sx) + rise * rise), crossing > w.base / 2};
}

/// Half as many buckets across the mesh as it has vertices: few share one, few are empty. Fewer
/// where the longest side would need too large a ring.
BucketRing bucketRing(const std::vector<Wedge>& wedges, const Points& vertices) {
  constexpr double LARGEST = 2048;
  double longest = 0;
  for (const Wedge& w : wedges) longest = std::max(longest, double{w.side});
  BucketRing ring;
  if (!(longest > 0)) return ring;
  const double across = (vertices.colwise().maxCoeff() - vertices.colwise().minCoeff()).norm();
  const double width = std::max(longest / (LARGEST - 4), 2 * across / vertices.rows());
  ring.per_length = 1 / width;
  while (static_cast<double>(ring.size) < longest / width + 3) ring.size *= 2;
  return ring;
}

}  // namespace

/// What a march needs. Between two of them `done` is set in `order` alone, `is_goal` nowhere, the
/// front is empty.
struct GeodesicField::Workspace {
  BucketQueue front;
  std::vector<char> done;
  std::vector<char> is_goal;
  std::vector<int> refused;  // where the front did not go on
};

GeodesicField::GeodesicField() = default;
GeodesicField::~GeodesicField() = default;
GeodesicField::GeodesicField(GeodesicField&&) noexcept = default;
GeodesicField& GeodesicField::operator=(GeodesicField&&) noexcept = default;

struct FastMarching::Graph {
  std::vector<int> first_wedge;  // n + 1 offsets into wedges, by the vertex the front comes from
  std::vector<Wedge> wedges;
  BucketRing ring;

  int vertexCount() const { return static_cast<int>(first_wedge.size()) - 1; }
  void checkVertex(int v) const {
    require(v >= 0 && v < vertexCount(), "FastMarching: no vertex " + std::to_string(v));
  }

  /// Makes the field one that no front has touched, at the cost of what the last one reached.
  GeodesicField::Workspace& clear(GeodesicField& field) const;
  /// Runs the front from `source`; `accept(vertex, distance)` says whether the front goes on there,
  /// `stop()` whether all is done. The field must be clear.
  template <class Accept, class Stop>
  void run(int source, GeodesicField& field, Accept accept, Stop stop) const;
  void propagate(int v, GeodesicField& field) const;
};

GeodesicField::Workspace& FastMarching::Graph::clear(GeodesicField& field) const {
  if (!field.workspace_) field.workspace_ = std::make_unique<GeodesicField::Workspace>();
  GeodesicField::Workspace& work = *field.workspace_;
  const std::size_t n = vertexCount();
  if (field.distance.size() == n && field.predecessor.size() == n && work.done.size() == n) {
    for (int v : field.order) {
      field.distance[v] = INFINITE;
      field.predecessor[v] = -1;
      work.done[v] = 0;
    }
  } else {
    field.distance.assign(n, INFINITE);
    field.predecessor.assign(n, -1);
    work.done.assign(n, 0);
    work.is_goal.assign(n, 0);
  }
  field.order.clear();
  return work;
}

void FastMarching::Graph::propagate(int v, GeodesicField& field) const {
  const std::vector<char>& done = field.workspace_->done;
  const double da = field.distance[v];
  for (int i = first_wedge[v]; i < first_wedge[v + 1]; ++i) {
    const Wedge& w = wedges[i];
    if (done[w.target]) continue;
    const Arrival reached =
        done[w.other] ? arrival(w, da, field.distance[w.other]) : Arrival{da + w.side, false};
    if (reached.distance < field.distance[w.target]) {
      field.distance[w.target] = reached.distance;
      field.predecessor[w.target] = reached.through_other ? w.other : v;
      field.workspace_->front.push(reached.distance, w.target);
    }
  }
}

template <class Accept, class Stop>
void FastMarching::Graph::run(int source, GeodesicField& field, Accept accept, Stop stop) const {
  GeodesicField::Workspace& work = *field.workspace_;
  work.front.start(ring);
  field.distance[source] = 0;
  work.front.push(0, source);
  int v;
  while (!stop() && (v = work.front.pop(field.distance)) >= 0) {
    if (!accept(v, field.distance[v])) {
      // Not passed on: its neighbours must not lean on it either.
      field.distance[v] = -1;
      work.refused.push_back(v);
      continue;
    }
    work.done[v] = 1;
    field.order.push_back(v);
    propagate(v, field);
  }
  // What the front touched but did not reach is no distance yet.
  const auto forget = [&](int touched) {
    field.distance[touched] = INFINITE;
    field.predecessor[touched] = -1;
  };
  while ((v = work.front.pop(field.distance)) >= 0) forget(v);
  for (int refused : work.refused) forget(refused);
  work.refused.clear();
}

FastMarching::FastMarching(const TriangleMesh& mesh) {
  const int n = static_cast<int>(mesh.vertices.rows());
  const std::vector<UnfoldedTriangle> triangles = unfoldedTriangles(mesh);
  auto graph = std::make_unique<Graph>();
  graph->first_wedge.assign(n + 1, 0);
  for (const UnfoldedTriangle& t : triangles) {
    ++graph->first_wedge[t.left + 1];
    ++graph->first_wedge[t.right + 1];
  }
  for (int v = 0; v < n; ++v) graph->first_wedge[v + 1] += graph->first_wedge[v];
  graph->wedges.resize(2 * triangles.size());
  std::vector<int> next(graph->first_wedge.begin(), graph->first_wedge.end() - 1);
  const auto add = [&](int from, int target, int other, double base, double x, double y) {
    graph->wedges[next[from]++] = {target,
                                   other,
                                   static_cast<float>(base),
                                   static_cast<float>(x),
                                   static_cast<float>(y),
                                   static_cast<float>(std::hypot(x, y))};
  };
  for (const UnfoldedTriangle& t : triangles) {
    add(t.left, t.apex, t.right, t.base, t.x, t.y);
    add(t.right, t.apex, t.left, t.base, t.base - t.x, t.y);
  }
  graph->ring = bucketRing(graph->wedges, mesh.vertices);
  graph_ = std::move(graph);
}

FastMarching::~FastMarching() = default;
FastMarching::FastMarching(FastMarching&&) noexcept = default;
FastMarching& FastMarching::operator=(FastMarching&&) noexcept = default;

int FastMarching::vertexCount() const { return graph_->vertexCount(); }

void FastMarching::march(int source, GeodesicField& field) const {
  graph_->checkVertex(source);
  graph_->clear(field);
  graph_->run(
      source, field, [](int, double) { return true; }, [] { return false; });
}

void FastMarching::marchUntil(int source,
                              const std::vector<int>& goals,
                              GeodesicField& field) const {
  graph_->checkVertex(source);
  for (int goal : goals) graph_->checkVertex(goal);
  std::vector<char>& is_goal = graph_->clear(field).is_goal;
  int open = 0;
  for (int goal : goals) {
    open += !is_goal[goal];
    is_goal[goal] = 1;
  }
  graph_->run(
      source,
      field,
      [&](int v, double) {
        open -= is_goal[v];
        return true;
      },
      [&] { return open == 0; });
  for (int goal : goals) is_goal[goal] = 0;
}

void FastMarching::marchWithin(int source,
                               int label,
                               std::vector<double>& distance,
                               std::vector<int>& nearest,
                               GeodesicField& field) const {
  graph_->checkVertex(source);
  graph_->clear(field);
  graph_->run(
      source,
      field,
      [&](int v, double reached) {
        if (!(reached < distance[v])) return false;
        distance[v] = reached;
        nearest[v] = label;
        return true;
      },
      [] { return false; });
}

}  // namespace posture
