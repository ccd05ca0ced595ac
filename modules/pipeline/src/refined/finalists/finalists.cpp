// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "refined/finalists/finalists.h"

#include <posture/core/parallel.h>
#include <posture/mesh/connected_parts.h>
#include <posture/refine/bend.h>
#include <posture/refine/conform.h>

#include "refined/finalists/by_score.h"
#include <algorithm>
#include <iterator>
#include <utility>

namespace posture {
namespace {

constexpr int MOST_FINALISTS = 8, MOST_LAID = 4;

/// How many of the best finalists are bent further, and in how many rounds at most.
constexpr int BENT_FURTHER = 16, MOST_FURTHER = 4;

/// The low start mends limbs turned inside out, the high one keeps those a low one would twist.
const std::vector<std::vector<int>>& starts() {
  static const std::vector<std::vector<int>> SIZES{{12, 24, 36, 48, FINALIST_BASIS},
                                                   {30, 40, 50, FINALIST_BASIS}};
  return SIZES;
}

/// Parts exchanged between finalists: at least so many vertices of a coarse mesh, so many tried at
/// once, and so often.
constexpr int LEAST_PART = 8, MOST_EXCHANGES = 3;
constexpr std::size_t MOST_MIXTURES = 8;

/// Connected parts of the source where two maps lead to different places, at most half of it each.
std::vector<std::vector<int>> differingParts(const SpectralSurface& source,
                                             const SpectralSurface& target,
                                             const std::vector<int>& x,
                                             const std::vector<int>& y,
                                             double gap) {
  const int n = static_cast<int>(x.size());
  std::vector<char> open(n);
  for (int v = 0; v < n; ++v)
    open[v] = (target.mesh.vertices.row(x[v]) - target.mesh.vertices.row(y[v])).norm() > gap;
  std::vector<std::vector<int>> parts = markedParts(source.neighbors, std::move(open));
  parts.erase(std::remove_if(parts.begin(),
                             parts.end(),
                             [&](const std::vector<int>& part) {
                               return static_cast<int>(part.size()) < LEAST_PART ||
                                      2 * static_cast<int>(part.size()) > n;
                             }),
              parts.end());
  return parts;
}

/// `base` with `part` of the source, and what is mapped there from the target, as in `donor`.
VertexMaps withPart(const VertexMaps& base, const VertexMaps& donor, const std::vector<int>& part) {
  VertexMaps mixed = base;
  std::vector<char> inside(base.forward.size(), 0);
  for (int v : part) {
    inside[v] = 1;
    mixed.forward[v] = donor.forward[v];
  }
  for (std::size_t t = 0; t < mixed.backward.size(); ++t)
    if (inside[donor.backward[t]] || inside[base.backward[t]])
      mixed.backward[t] = donor.backward[t];
  return mixed;
}

}  // namespace

std::vector<Finalist> registerFinalists(const SpectralSurface& source,
                                        const SpectralSurface& target,
                                        const SampledShape& source_samples,
                                        const SampledShape& target_samples,
                                        const std::vector<SampleMap>& pool) {
  std::vector<Finalist> candidates(pool.size());
  parallelFor(static_cast<int>(pool.size()), [&](int i) {
    Finalist& candidate = candidates[i];
    candidate.maps = spreadToVertices(
        source, target, source_samples.functions, target_samples.functions, pool[i], SAMPLE_BASIS);
    candidate.orientation = orientation(source, target, candidate.maps);
  });
  std::vector<Finalist> finalists;
  for (const Finalist& candidate : candidates)
    if (candidate.orientation > LEAST_ORIENTATION &&
        finalists.size() < MOST_FINALISTS * starts().size())
      finalists.insert(finalists.end(), starts().size(), candidate);
  parallelFor(static_cast<int>(finalists.size()), [&](int i) {
    Finalist& finalist = finalists[i];
    finalist.maps = bend(source, target, starts()[i % starts().size()], finalist.maps);
    finalist.score = scoreMaps(source, target, finalist.maps);
  });
  sortByScore(finalists);
  return finalists;
}

void bendFurther(const SpectralSurface& source,
                 const SpectralSurface& target,
                 std::vector<Finalist>& finalists) {
  parallelFor(std::min(BENT_FURTHER, static_cast<int>(finalists.size())), [&](int i) {
    Finalist& finalist = finalists[i];
    for (int round = 0; round < MOST_FURTHER; ++round) {
      Finalist next = finalist;
      next.maps = bend(source, target, starts().front(), next.maps);
      next.score = scoreMaps(source, target, next.maps);
      if (next.score.total() >= finalist.score.total()) break;
      finalist = std::move(next);
    }
  });
  sortByScore(finalists);
}

std::vector<Finalist> layFinalists(const SpectralSurface& source,
                                   const SpectralSurface& target,
                                   const SurfacePlaces& source_places,
                                   const SurfacePlaces& target_places) {
  const std::vector<Similarity> ways = layOver(source_places, target_places, MOST_LAID);
  std::vector<Finalist> laid(ways.size());
  parallelFor(static_cast<int>(ways.size()), [&](int i) {
    const Similarity& way = ways[i];
    Finalist& finalist = laid[i];
    finalist.orientation = -1;
    finalist.laid = true;
    finalist.scale = way.scale;
    const SpectralSurface scaled({way.scale * source.mesh.vertices, source.mesh.faces},
                                 source.functions.cast<double>() / way.scale,
                                 source.eigenvalues / (way.scale * way.scale));
    try {
      finalist.bent = conform(scaled,
                              target,
                              way.of(source.mesh.vertices),
                              way.scale * way.inverseOf(target.mesh.vertices));
    } catch (const TornSurface&) {  // the others may be bent
      return;
    }
    finalist.maps = finalist.bent->maps;
    finalist.orientation = orientation(scaled, target, finalist.maps);
    finalist.score = scoreBent(scaled, target, *finalist.bent, true);
  });
  laid.erase(std::remove_if(laid.begin(),
                            laid.end(),
                            [](const Finalist& f) { return f.orientation <= LEAST_ORIENTATION; }),
             laid.end());
  sortByScore(laid);
  return laid;
}

std::vector<Finalist> joined(std::vector<Finalist> some, std::vector<Finalist> others) {
  std::move(others.begin(), others.end(), std::back_inserter(some));
  sortByScore(some);
  return some;
}

void exchangeParts(const SpectralSurface& source,
                   const SpectralSurface& target,
                   double gap,
                   std::vector<Finalist>& finalists) {
  for (int round = 0; round < MOST_EXCHANGES && !finalists.empty(); ++round) {
    const VertexMaps& base = finalists.front().maps;
    std::vector<VertexMaps> mixed;
    for (const Finalist& donor : finalists)
      for (const std::vector<int>& part :
           differingParts(source, target, base.forward, donor.maps.forward, gap)) {
        VertexMaps candidate = withPart(base, donor.maps, part);
        // Starts of one candidate often end in the same place.
        const bool known = std::any_of(mixed.begin(), mixed.end(), [&](const VertexMaps& other) {
          return differingParts(source, target, candidate.forward, other.forward, gap).empty();
        });
        if (!known && mixed.size() < MOST_MIXTURES) mixed.push_back(std::move(candidate));
      }
    std::vector<MapScore> scores(mixed.size());
    parallelFor(static_cast<int>(mixed.size()), [&](int i) {
      mixed[i] = bend(source, target, starts().back(), mixed[i]);
      scores[i] = scoreMaps(source, target, mixed[i]);
    });
    int best = -1;
    double least = finalists.front().score.total() - SCORE_NOISE;
    for (std::size_t i = 0; i < mixed.size(); ++i)
      if (scores[i].total() < least) {
        least = scores[i].total();
        best = static_cast<int>(i);
      }
    if (best < 0) return;
    if (round == 0) finalists.insert(finalists.begin(), finalists.front());
    Finalist mixture;  // bent from its maps alone, on the surfaces as they are
    mixture.orientation = finalists.front().orientation;
    mixture.maps = std::move(mixed[best]);
    mixture.score = scores[best];
    finalists.front() = std::move(mixture);
  }
}

}  // namespace posture
