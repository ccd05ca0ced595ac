// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/refine/rigid_ends.h>

#include "far_apart.h"
#include "lay_ends.h"
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace posture {
namespace {

/// Vertices of an end that tell a motion; whether they tell it well is seen by the other ways.
constexpr std::size_t FEWEST = 20;

/// Of the misfit in the next best way: heads of cats and horses have 0.3 to 0.4, people's hands and
/// feet on finer meshes 0.2 to 0.5, other ends 0.6 and more.
constexpr double CLEARLY_BETTER = 0.5;

/// An end that fits so many times worse does not fit: on a stump it may have thirty times the
/// misfit, and would outvote all others.
constexpr double DOES_NOT_FIT = 2;

/// Of the mean squared edge, the misfit that says something: twice that of a surface on itself with
/// its vertices elsewhere (the second moment of a hexagon's places). A round end has less in many
/// ways.
constexpr double SAMPLING = 0.28;

/// Of the misfit of an end's mirror image, its own where it tells that it is of the same hand,
/// twice what is chance added to both; and the other way round. Right and wrong hands of people
/// have 0.3 to 0.65, feet of animals up to 0.8, ends that tell nothing 0.8 and more.
constexpr double SAME_HAND = 0.75;

constexpr std::size_t PLACES_ON_END = 5;

/// An end, the one that a map takes it to, and how it lies there.
struct Look {
  EndFit fit;
  LimbEnd a, b;
  LaidEnd mapped, best;  // nothing where it was not laid
};

bool tells(const LimbEnd& end) { return end.size >= FEWEST; }

void markEnd(const LimbEnd& end, std::vector<char>& seen) {
  for (std::size_t i = 0; i < end.wide.size(); ++i)
    if (end.inside[i]) seen[end.wide[i]] = 1;
}

/// \param ways  the best first, at least one.
EndFit fitOf(int tip, double by_chance, const std::vector<LaidEnd>& ways) {
  return {tip,
          ways.front().misfit,
          ways.size() > 1 ? ways[1].misfit : std::numeric_limits<double>::infinity(),
          by_chance};
}

/// \param whole_only  whether ends that are not whole are not laid either.
std::vector<Look> lookAtEnds(const SpectralSurface& a,
                             const SpectralSurface& b,
                             const std::vector<int>& tips,
                             const VertexMaps& maps,
                             bool whole_only) {
  constexpr double INFINITE = std::numeric_limits<double>::infinity();
  const Vector remote_a = remoteness(a), remote_b = remoteness(b);
  std::vector<char> seen(a.mesh.vertices.rows(), 0);
  std::vector<Look> looks;
  for (int tip : tips) {
    if (seen[tip]) continue;
    Look look{{tip, INFINITE, INFINITE, 0},
              endAt(a, remote_a, tip),
              endAt(b, remote_b, maps.forward[tip]),
              {},
              {}};
    markEnd(look.a, seen);
    look.fit.by_chance = SAMPLING * std::max(look.a.squared_edge, look.b.squared_edge);
    if (tells(look.a) && tells(look.b) && (!whole_only || (isWhole(look.a) && isWhole(look.b)))) {
      look.mapped = asMapped(b, look.a, maps);
      std::vector<LaidEnd> ways = waysToLay(look.a, look.b, look.mapped);
      look.fit = fitOf(tip, look.fit.by_chance, ways);
      look.best = std::move(ways.front());
    }
    looks.push_back(std::move(look));
  }
  return looks;
}

std::vector<int> verticesOf(const LimbEnd& end) {
  std::vector<int> vertices;
  for (std::size_t i = 0; i < end.wide.size(); ++i)
    if (end.inside[i]) vertices.push_back(end.wide[i]);
  return vertices;
}

/// Vertices spread over an end, the one nearest to the tip first, and what they lie next to.
std::vector<PlacePair> placesOn(const SpectralSurface& a,
                                const LimbEnd& end,
                                const LimbEnd& other,
                                int tip,
                                const LaidEnd& laid) {
  std::vector<int> on_end;
  for (const ClosestPair& pair : laid.pairs) on_end.push_back(end.wide[pair.a]);
  const std::vector<double>& from_tip = a.distances.from(tip);
  const auto nearest = std::min_element(
      on_end.begin(), on_end.end(), [&](int v, int w) { return from_tip[v] < from_tip[w]; });
  std::vector<PlacePair> places;
  for (int i :
       farApart(a.distances, on_end, static_cast<int>(nearest - on_end.begin()), PLACES_ON_END))
    places.push_back({on_end[i], other.wide[laid.pairs[i].b]});
  return places;
}

}  // namespace

bool EndFit::fitsInOneWay() const { return next > std::max(misfit / CLEARLY_BETTER, by_chance); }

std::vector<RigidEnd> rigidEnds(const SpectralSurface& a,
                                const SpectralSurface& b,
                                const std::vector<int>& tips,
                                const VertexMaps& maps) {
  std::vector<RigidEnd> ends;
  for (const Look& look : lookAtEnds(a, b, tips, maps, false)) {
    if (!look.fit.fitsInOneWay()) continue;
    RigidEnd end;
    end.vertices = verticesOf(look.a);
    end.of_b = verticesOf(look.b);
    end.places = placesOn(a, look.a, look.b, look.fit.tip, look.best);
    end.motion = look.best.motion;
    end.turned = angleBetween(look.best, look.mapped) > SAME_TURN;
    ends.push_back(std::move(end));
  }
  return ends;
}

std::vector<EndFit> fitEnds(const SpectralSurface& a,
                            const SpectralSurface& b,
                            const std::vector<int>& tips,
                            const VertexMaps& maps) {
  std::vector<EndFit> fits;
  for (const Look& look : lookAtEnds(a, b, tips, maps, true)) fits.push_back(look.fit);
  return fits;
}

HandVote handVote(const SpectralSurface& a,
                  const SpectralSurface& b,
                  const std::vector<int>& tips_a,
                  const std::vector<int>& tips_b,
                  const VertexMaps& maps) {
  HandVote vote;
  const Vector remote_a = remoteness(a), remote_b = remoteness(b);
  std::vector<char> seen_a(a.mesh.vertices.rows(), 0), seen_b(b.mesh.vertices.rows(), 0);
  const auto count = [&](int tip_a, int tip_b) {
    const LimbEnd end = endAt(a, remote_a, tip_a), other = endAt(b, remote_b, tip_b);
    markEnd(end, seen_a);
    markEnd(other, seen_b);
    if (!tells(end) || !tells(other) || !isWhole(end) || !isWhole(other)) return;
    const LimbEnd image = mirrorImage(end);
    const double by_chance = SAMPLING * std::max(end.squared_edge, other.squared_edge);
    const EndFit own = fitOf(tip_a, by_chance, waysToLay(end, other, asMapped(b, end, maps))),
                 mirrored =
                     fitOf(tip_a, by_chance, waysToLay(image, other, asMapped(b, image, maps)));
    const auto isClearly = [&](const EndFit& better, const EndFit& worse) {
      return better.fitsInOneWay() &&
             better.misfit + by_chance < SAME_HAND * (worse.misfit + by_chance);
    };
    vote.for_it += isClearly(own, mirrored);
    vote.against_it += isClearly(mirrored, own);
  };
  for (int tip : tips_a)
    if (seen_a[tip] == 0) count(tip, maps.forward[tip]);
  for (int tip : tips_b)
    if (seen_b[tip] == 0 && seen_a[maps.backward[tip]] == 0) count(maps.backward[tip], tip);
  return vote;
}

std::vector<double> endDisagreements(const std::vector<std::vector<EndFit>>& fits) {
  std::vector<double> sums(fits.size(), 0);
  if (fits.empty()) return sums;
  for (const EndFit& first : fits.front()) {
    std::vector<EndFit> of_end;
    for (const std::vector<EndFit>& map : fits)
      for (const EndFit& fit : map)
        if (fit.tip == first.tip && std::isfinite(fit.misfit)) of_end.push_back(fit);
    if (of_end.size() < fits.size()) continue;
    const EndFit* best = nullptr;
    for (const EndFit& fit : of_end)
      if (fit.fitsInOneWay() && (best == nullptr || fit.misfit < best->misfit)) best = &fit;
    if (best == nullptr) continue;
    for (std::size_t k = 0; k < fits.size(); ++k) {
      const double by_chance =
          std::max({best->by_chance, of_end[k].by_chance, std::numeric_limits<double>::min()});
      const double worse = (of_end[k].misfit + by_chance) / (best->misfit + by_chance);
      sums[k] += std::log(std::clamp(worse, 1.0, DOES_NOT_FIT));
    }
  }
  return sums;
}

}  // namespace posture
