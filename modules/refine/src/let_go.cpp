// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/parallel.h>
#include <posture/mesh/edges.h>
#include <posture/refine/lay_over.h>
#include <posture/refine/let_go.h>

#include <Eigen/Geometry>

#include "belief.h"
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace posture {
namespace {

/// Places between which distances are compared, and how far apart, in square roots of the area:
/// nearer ones change by as much as maps are off, farther ones tell of more than the place.
constexpr int PLACES = 150;
constexpr double NEAR = 0.08, FAR = 0.25;

/// Median relative change of the distances around a place, and how many times what is usual on the
/// body, from which on the place is wrong. docs/decisions/attempts.md has the measurements.
constexpr double TORN = 0.25, TIMES_USUAL = 3;

/// How much of the surface around a part tells how it goes, in square roots of the area.
constexpr double SURROUNDINGS = 0.15;
constexpr std::size_t FEWEST = 6;  ///< vertices that tell a motion

/// Rotations and places alternate so often where a part is laid anew.
constexpr int LAYING_STEPS = 50;

/// Where more of a surface is misplaced, not a part is wrong but the map.
constexpr double MOST = 0.5;

/// What is let go of shows what else is held by it alone.
constexpr int TIMES = 4;

/// Shares of the softness, stiff, then soft.
constexpr double SOFTENING[] = {0.1, 0.3, 1};
constexpr int ROUNDS = 6;

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Median relative change of the distances from each of the places to those around it.
std::vector<double> changesAround(const SpectralSurface& a,
                                  const SpectralSurface& b,
                                  const std::vector<int>& places,
                                  const std::vector<int>& matches) {
  std::vector<double> change(places.size(), 0);
  parallelFor(static_cast<int>(places.size()), [&](int i) {
    const std::vector<double>&here = a.distances.from(places[i]),
          &there = b.distances.from(matches[places[i]]);
    std::vector<double> changes;
    for (int place : places) {
      const double x = here[place], y = there[matches[place]];
      if (x > NEAR && x < FAR && std::isfinite(y)) changes.push_back(2 * std::abs(x - y) / (x + y));
    }
    if (!changes.empty()) change[i] = median(std::move(changes));
  });
  return change;
}

/// The vertices around a part that are not marked themselves.
std::vector<int> surroundings(const BendableSurface& a,
                              const std::vector<int>& part,
                              const std::vector<char>& marked) {
  const long rings = std::max(1L, std::lround(SURROUNDINGS / meanEdgeLength(a.mesh)));
  std::vector<char> seen = marked;
  std::vector<int> found, front = part;
  for (long ring = 0; ring < rings; ++ring) {
    std::vector<int> next;
    for (int v : front)
      for (const int* w = a.neighbors.begin(v); w != a.neighbors.end(v); ++w)
        if (!seen[*w]) {
          seen[*w] = 1;
          next.push_back(*w);
        }
    found.insert(found.end(), next.begin(), next.end());
    front = std::move(next);
  }
  return found;
}

/// Where a surface comes to lie when what is marked goes as the surface around it does.
Points laidAnew(const BendableSurface& a,
                const std::vector<char>& marked,
                double softness,
                const Points& bent) {
  Points laid = bent;
  for (const std::vector<int>& part : markedParts(a, marked)) {
    const std::vector<int> around = surroundings(a, part, marked);
    if (around.size() < FEWEST) continue;
    const Eigen::MatrixXd from = a.mesh.vertices(around, Eigen::all).transpose(),
                          to = bent(around, Eigen::all).transpose();
    Eigen::Isometry3d motion;
    motion.matrix() = Eigen::umeyama(from, to, false);
    for (int v : part) laid.row(v) = (motion * Eigen::Vector3d(a.mesh.vertices.row(v))).transpose();
  }
  Vector held = Vector::Ones(laid.rows());
  for (int v = 0; v < laid.rows(); ++v)
    if (marked[v]) held[v] = 0;
  return a.arap.pull(laid, laid, a.arap.attract(softness, held), LAYING_STEPS);
}

/// What of the vertices marked lies farther than an edge from its match on `b`.
std::vector<char> stillApart(const BendableSurface& b,
                             const std::vector<int>& matches,
                             const Points& bent,
                             std::vector<char> marked) {
  const double edge = meanEdgeLength(b.mesh);
  for (int v = 0; v < bent.rows(); ++v)
    if ((bent.row(v) - b.mesh.vertices.row(matches[v])).norm() < edge) marked[v] = 0;
  return marked;
}

/// The pair without what is marked, as far as that does not find another place.
BentPair without(const SpectralSurface& a,
                 const SpectralSurface& b,
                 const std::vector<char>& of_a,
                 const std::vector<char>& of_b,
                 double softness,
                 const BentPair& pair) {
  BentPair loose = conform(
      a, b, laidAnew(a, of_a, softness, pair.bent_a), laidAnew(b, of_b, softness, pair.bent_b));
  const auto leaveApart = [&](const std::vector<char>& some_a, const std::vector<char>& some_b) {
    loose.apart_a = stillApart(b, loose.maps.forward, loose.bent_a, some_a);
    loose.apart_b = stillApart(a, loose.maps.backward, loose.bent_b, some_b);
  };
  leaveApart(of_a, of_b);
  for (double share : SOFTENING) settle(a, b, share * softness, ROUNDS, loose);
  leaveApart(std::vector<char>(loose.apart_a), std::vector<char>(loose.apart_b));
  return loose;
}

/// `marked`, and what is apart already. \return  whether that is more than what is apart.
bool addTo(std::vector<char>& marked, const std::vector<char>& apart) {
  bool more = false;
  for (std::size_t v = 0; v < marked.size(); ++v) {
    const bool known = !apart.empty() && apart[v];
    more |= marked[v] && !known;
    marked[v] |= known;
  }
  return more;
}

}  // namespace

std::vector<char> misplaced(const SpectralSurface& a,
                            const SpectralSurface& b,
                            const std::vector<int>& matches) {
  const int n = static_cast<int>(matches.size());
  const Vector believed = belief(a, b, matches);
  std::vector<int> places;
  for (int v = 0; v < std::min(PLACES, n); ++v)
    if (believed[v] > 0) places.push_back(v);
  std::vector<char> marked(n, 0);
  if (places.empty()) return marked;
  const std::vector<double> change = changesAround(a, b, places, matches);
  const double torn = std::max(TORN, TIMES_USUAL * median(change));
  if (std::none_of(change.begin(), change.end(), [&](double c) { return c > torn; })) return marked;
  std::vector<double> nearest(n, std::numeric_limits<double>::infinity());
  for (std::size_t i = 0; i < places.size(); ++i) {
    const std::vector<double>& distance = a.distances.from(places[i]);
    for (int v = 0; v < n; ++v)
      if (distance[v] < nearest[v]) {
        nearest[v] = distance[v];
        marked[v] = change[i] > torn;
      }
  }
  return marked;
}

std::optional<MapScore> letGo(const SpectralSurface& a,
                              const SpectralSurface& b,
                              double softness,
                              double least_gain,
                              BentPair& pair) {
  double least = scoreBent(a, b, pair, false).total();
  std::optional<MapScore> better;
  for (int time = 0; time < TIMES; ++time) {
    std::vector<char> of_a = misplaced(a, b, pair.maps.forward),
                      of_b = misplaced(b, a, pair.maps.backward);
    const bool more_of_a = addTo(of_a, pair.apart_a), more_of_b = addTo(of_b, pair.apart_b);
    if (!more_of_a && !more_of_b) break;
    if (areaShare(a, of_a) > MOST || areaShare(b, of_b) > MOST) break;
    BentPair loose = without(a, b, of_a, of_b, softness, pair);
    const MapScore score = scoreBent(a, b, loose, false);
    if (!(score.total() < least - least_gain)) break;
    least = score.total();
    better = score;
    pair = std::move(loose);
  }
  return better;
}

}  // namespace posture
