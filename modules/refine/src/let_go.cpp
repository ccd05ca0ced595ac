// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/median.h>
#include <posture/core/parallel.h>
#include <posture/refine/let_go.h>

#include "belief.h"
#include "lay_anew.h"
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

/// What is let go of shows what else is held by it alone.
constexpr int TIMES = 4;

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

/// Share of the area that may be apart in the end, by what is apart in the beginning.
double mostApart(const BendableSurface& surface, const std::vector<char>& apart) {
  const double before = areaShare(surface, apart);
  return before + MOST_LET_GO * (1 - before);
}

}  // namespace

std::vector<char> misplaced(const SpectralSurface& a,
                            const SpectralSurface& b,
                            const std::vector<int>& matches,
                            const std::vector<char>& apart) {
  const int n = static_cast<int>(matches.size());
  const Vector believed = belief(a, b, matches);
  std::vector<int> places;
  int considered = 0;
  for (int v = 0; v < n && considered < PLACES; ++v) {
    if (isApart(apart, v)) continue;
    ++considered;
    if (believed[v] > 0) places.push_back(v);
  }
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
  const double most_a = mostApart(a, pair.apart_a), most_b = mostApart(b, pair.apart_b);
  std::optional<double> least;  // what is misplaced nowhere needs no score
  std::optional<MapScore> better;
  for (int time = 0; time < TIMES; ++time) {
    std::vector<char> of_a = misplaced(a, b, pair.maps.forward, pair.apart_a),
                      of_b = misplaced(b, a, pair.maps.backward, pair.apart_b);
    const bool more_of_a = addApart(of_a, pair.apart_a), more_of_b = addApart(of_b, pair.apart_b);
    if (!more_of_a && !more_of_b) break;
    if (areaShare(a, of_a) > most_a || areaShare(b, of_b) > most_b) break;
    if (!least) least = scoreBent(a, b, pair, false).total();
    BentPair loose = laidAnew(a, b, of_a, of_b, softness, pair);
    const MapScore score = scoreBent(a, b, loose, false);
    if (!(score.total() < *least - least_gain)) break;
    least = score.total();
    better = score;
    pair = std::move(loose);
  }
  return better;
}

}  // namespace posture
