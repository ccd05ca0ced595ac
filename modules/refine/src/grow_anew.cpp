// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/parallel.h>
#include <posture/mesh/edges.h>
#include <posture/refine/grow_anew.h>
#include <posture/refine/let_go.h>
#include <posture/refine/settle.h>

#include "far_apart.h"
#include "lay_anew.h"
#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>

namespace posture {
namespace {

/// Around so many places, far from each other, what is near is kept, so much of the area.
constexpr int PLACES = 8;
constexpr double KEPT = 0.4;

/// Places are looked for among so many vertices.
constexpr int SPREAD = 150;

/// Places nearer than so many edges are the same, and an edge whose ends are taken farther apart
/// than so many times its length is torn.
constexpr double SAME = 2, STRETCH = 2;

/// Of the vertices with a counterpart, some far from each other along the surface.
std::vector<int> placesFarApart(const SpectralSurface& a, const std::vector<char>& apart) {
  std::vector<int> among;
  for (int v = 0; v < std::min(SPREAD, static_cast<int>(a.mesh.vertices.rows())); ++v)
    if (!isApart(apart, v)) among.push_back(v);
  std::vector<int> places;
  for (int i : farApart(a.distances, among, 0, std::min<std::size_t>(PLACES, among.size())))
    places.push_back(among[i]);
  return places;
}

/// All but what is nearest to a place and has a counterpart, KEPT of the area.
std::vector<char> allButAround(const SpectralSurface& a,
                               const std::vector<char>& apart,
                               int place) {
  const std::vector<double>& distance = a.distances.from(place);
  std::vector<int> order(distance.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(
      order.begin(), order.end(), [&](int v, int w) { return distance[v] < distance[w]; });
  std::vector<char> marked(distance.size(), 1);
  double left = KEPT * a.laplacian.mass.sum();
  for (auto v = order.begin(); v != order.end() && left > 0; ++v) {
    if (isApart(apart, *v)) continue;
    marked[*v] = 0;
    left -= a.laplacian.mass[*v];
  }
  return marked;
}

/// What of b is matched with the vertices of a that are marked.
std::vector<char> matchedWith(const std::vector<char>& marked, const std::vector<int>& backward) {
  std::vector<char> of_b;
  of_b.reserve(backward.size());
  for (int v : backward) of_b.push_back(marked[v]);
  return of_b;
}

/// The vertices of a that are apart now and were not, and hang together, under the map before, with
/// what lies now as it did.
std::vector<int> hangingOn(const SpectralSurface& a,
                           const SpectralSurface& b,
                           const BentPair& before,
                           const BentPair& now) {
  const double edge = meanEdgeLength(b.mesh);
  const auto place = [&](const BentPair& pair, int v) {
    return b.mesh.vertices.row(pair.maps.forward[v]);
  };
  std::vector<int> front, hanging;
  for (int v = 0; v < a.mesh.vertices.rows(); ++v)
    if (!isApart(now.apart_a, v) && !isApart(before.apart_a, v) &&
        (place(before, v) - place(now, v)).norm() < SAME * edge)
      front.push_back(v);
  std::vector<char> seen(a.mesh.vertices.rows(), 0);
  while (!front.empty()) {
    const int v = front.back();
    front.pop_back();
    for (const int* w = a.neighbors.begin(v); w != a.neighbors.end(v); ++w) {
      if (seen[*w] || !isApart(now.apart_a, *w) || isApart(before.apart_a, *w)) continue;
      const double length = (a.mesh.vertices.row(v) - a.mesh.vertices.row(*w)).norm();
      if ((place(before, v) - place(before, *w)).norm() > STRETCH * length + edge) continue;
      seen[*w] = 1;
      hanging.push_back(*w);
      front.push_back(*w);
    }
  }
  return hanging;
}

/// A limb that bends otherwise than the part it was laid with does not find back to its
/// counterpart. Where the map before leads to it without a jump from what lies as it did, that is
/// taken up again.
void takeUpAgain(const SpectralSurface& a,
                 const SpectralSurface& b,
                 const BentPair& before,
                 double softness,
                 BentPair& now) {
  const std::vector<int> of_a = hangingOn(a, b, before, now),
                         of_b = hangingOn(b, a, reversed(before), reversed(now));
  if (of_a.empty() && of_b.empty()) return;
  for (int v : of_a) {
    now.maps.forward[v] = before.maps.forward[v];
    now.bent_a.row(v) = before.bent_a.row(v);
    now.apart_a[v] = 0;
  }
  for (int v : of_b) {
    now.maps.backward[v] = before.maps.backward[v];
    now.bent_b.row(v) = before.bent_b.row(v);
    now.apart_b[v] = 0;
  }
  dropIfNothingIsApart(now);
  settleSoftening(a, b, softness, now);
}

}  // namespace

std::vector<ScoredPair> growAnew(const SpectralSurface& a,
                                 const SpectralSurface& b,
                                 double softness,
                                 const BentPair& best,
                                 const BentPair& pair) {
  std::vector<std::vector<char>> rests;
  for (int place : placesFarApart(a, pair.apart_a))
    rests.push_back(allButAround(a, pair.apart_a, place));
  std::vector<std::optional<ScoredPair>> tried(rests.size());
  parallelFor(static_cast<int>(rests.size()), [&](int i) {
    std::vector<char>& of_a = rests[i];
    std::vector<char> of_b = matchedWith(of_a, pair.maps.backward);
    addApart(of_a, pair.apart_a);
    addApart(of_b, pair.apart_b);
    try {
      BentPair grown = laidAnew(a, b, of_a, of_b, softness, pair);
      takeUpAgain(a, b, pair, softness, grown);
      takeUpAgain(a, b, best, softness, grown);
      const MapScore score = scoreBent(a, b, grown, false);
      if (score.let_go <= MOST_LET_GO) tried[i] = ScoredPair{std::move(grown), score};
    } catch (const TornSurface&) {  // nothing that is kept has a counterpart
    }
  });
  std::vector<ScoredPair> grown;
  for (std::optional<ScoredPair>& one : tried)
    if (one) grown.push_back(std::move(*one));
  return grown;
}

}  // namespace posture
