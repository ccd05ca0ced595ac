// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "finalists.h"

#include <posture/core/parallel.h>
#include <posture/refine/bend.h>
#include <posture/refine/grow_anew.h>
#include <posture/refine/let_go.h>

#include "by_score.h"
#include "verdict.h"
#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>

namespace posture {
namespace {

/// Right candidates have 0.38 and more, mirrored ones -0.35 and less; between them are maps that
/// are torn, which are no use either.
constexpr double LEAST_ORIENTATION = 0.2;

constexpr int MOST_FINALISTS = 8, MOST_LAID = 4;

/// Of different answers so many are tried without what they misplace.
constexpr int MOST_LOOSENED = 8;

/// How finalists settle before parts of them are laid anew.
const std::vector<double> SETTLING{0.1, 0.3};
constexpr int SETTLING_ROUNDS = 6;

/// So many different answers are grown anew, and of what comes of it the best are let go of what
/// they misplace.
constexpr std::size_t MOST_GROWN_FROM = 4, MOST_GROWN = 6;

/// So many are bent further, so often at most.
constexpr int BENT_FURTHER = 16, MOST_FURTHER = 4;

/// Where the sample maps end.
constexpr int CANDIDATE_BASIS = 36;

/// The low start mends limbs turned inside out, the high one keeps those a low one would twist.
const std::vector<std::vector<int>> STARTS{{12, 24, 36, 48, FINALIST_BASIS},
                                           {30, 40, 50, FINALIST_BASIS}};

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
  std::vector<std::vector<int>> parts = markedParts(source, std::move(open));
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

/// A finalist's map with both surfaces bent.
BentPair bentPair(const SpectralSurface& source,
                  const SpectralSurface& target,
                  double softness,
                  const Finalist& finalist) {
  if (finalist.bent) return *finalist.bent;
  const VertexMaps& maps = finalist.maps;
  BentPair pair{maps,
                target.mesh.vertices(maps.forward, Eigen::all),
                source.mesh.vertices(maps.backward, Eigen::all)};
  for (double share : SETTLING) settle(source, target, share * softness, SETTLING_ROUNDS, pair);
  return pair;
}

/// The score that changing a finalist's map has to beat: its own, or that of its bent surfaces once
/// they have settled. What settling alone gains, no change did.
double scoreToBeat(const SpectralSurface& source,
                   const SpectralSurface& target,
                   double softness,
                   const Finalist& finalist,
                   BentPair pair) {
  settle(source, target, softness, SETTLING_ROUNDS, pair);
  return std::min(finalist.score.total(), scoreBent(source, target, pair, false).total());
}

/// Mean distance between where two maps take the vertices that have a counterpart under both;
/// infinite where there are none.
double gapBetween(const SpectralSurface& target, const BentPair& x, const BentPair& y) {
  double sum = 0;
  int both = 0;
  for (std::size_t v = 0; v < x.maps.forward.size(); ++v) {
    if ((!x.apart_a.empty() && x.apart_a[v]) || (!y.apart_a.empty() && y.apart_a[v])) continue;
    ++both;
    sum +=
        (target.mesh.vertices.row(x.maps.forward[v]) - target.mesh.vertices.row(y.maps.forward[v]))
            .norm();
  }
  return both > 0 ? sum / both : std::numeric_limits<double>::infinity();
}

/// The finalist with another map, if that looks like one body and keeps the outside out.
std::optional<Finalist> withMap(const SpectralSurface& source,
                                const SpectralSurface& target,
                                BentPair pair,
                                const MapScore& score,
                                Finalist finalist) {
  if (!convinces(score.total())) return {};
  finalist.orientation = orientation(source, target, pair.maps);
  if (finalist.orientation <= LEAST_ORIENTATION) return {};
  finalist.score = score;
  finalist.maps = pair.maps;
  finalist.bent = std::move(pair);
  return finalist;
}

/// Those that there are, and the others, by increasing score.
std::vector<Finalist> joined(std::vector<std::optional<Finalist>> some,
                             std::vector<Finalist> others) {
  std::vector<Finalist> there;
  for (std::optional<Finalist>& one : some)
    if (one) there.push_back(std::move(*one));
  return joined(std::move(there), std::move(others));
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
    candidate.maps = spreadToVertices(source,
                                      target,
                                      source_samples.functions,
                                      target_samples.functions,
                                      pool[i],
                                      CANDIDATE_BASIS);
    candidate.orientation = orientation(source, target, candidate.maps);
  });
  std::vector<Finalist> finalists;
  for (const Finalist& candidate : candidates)
    if (candidate.orientation > LEAST_ORIENTATION &&
        finalists.size() < MOST_FINALISTS * STARTS.size())
      finalists.insert(finalists.end(), STARTS.size(), candidate);
  parallelFor(static_cast<int>(finalists.size()), [&](int i) {
    Finalist& finalist = finalists[i];
    finalist.maps = bend(source, target, STARTS[i % STARTS.size()], finalist.maps);
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
      next.maps = bend(source, target, STARTS.front(), next.maps);
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
    finalist.laid = true;
    finalist.scale = way.scale;
    const SpectralSurface scaled({way.scale * source.mesh.vertices, source.mesh.faces},
                                 source.functions.cast<double>() / way.scale,
                                 source.eigenvalues / (way.scale * way.scale));
    finalist.bent = conform(scaled,
                            target,
                            way.of(source.mesh.vertices),
                            way.scale * way.inverseOf(target.mesh.vertices));
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

std::vector<Finalist> withPartsLetGo(const SpectralSurface& source,
                                     const SpectralSurface& target,
                                     const std::vector<int>& distinct,
                                     std::vector<Finalist> finalists) {
  std::vector<Finalist> tried;
  for (int i : distinct)
    if (static_cast<int>(tried.size()) < MOST_LOOSENED && !finalists[i].laid)
      tried.push_back(finalists[i]);
  const double softness = settlingSoftness(source.eigenvalues, target.eigenvalues);
  std::vector<std::optional<Finalist>> loose(tried.size());
  parallelFor(static_cast<int>(tried.size()), [&](int i) {
    BentPair pair = bentPair(source, target, softness, tried[i]);
    const BentPair before = pair;
    const std::optional<MapScore> score = letGo(source, target, softness, SCORE_NOISE, pair);
    if (score &&
        score->total() < scoreToBeat(source, target, softness, tried[i], before) - SCORE_NOISE)
      loose[i] = withMap(source, target, std::move(pair), *score, tried[i]);
  });
  return joined(std::move(loose), std::move(finalists));
}

std::vector<Finalist> withPartsGrownAnew(const SpectralSurface& source,
                                         const SpectralSurface& target,
                                         const std::vector<int>& distinct,
                                         double gap,
                                         std::vector<Finalist> finalists) {
  struct Grown {
    const Finalist* from;
    BentPair pair;
    MapScore score;
  };
  const double softness = settlingSoftness(source.eigenvalues, target.eigenvalues);
  std::vector<Grown> grown;
  const std::size_t begun = std::min(MOST_GROWN_FROM, distinct.size());
  std::vector<BentPair> pairs(begun);
  std::vector<double> before(begun);
  parallelFor(static_cast<int>(begun), [&](int k) {
    const Finalist& finalist = finalists[distinct[k]];
    pairs[k] = bentPair(source, target, softness, finalist);
    before[k] = scoreToBeat(source, target, softness, finalist, pairs[k]);
  });
  for (std::size_t k = 0; k < begun; ++k)
    for (ScoredPair& one : growAnew(source, target, softness, pairs.front(), pairs[k])) {
      // The same answer once more, less of the body mapped, is no better.
      double known = before[k];
      for (std::size_t other = 0; other < begun; ++other)
        if (gapBetween(target, one.pair, pairs[other]) <= gap)
          known = std::min(known, before[other]);
      if (one.score.total() < known - SCORE_NOISE)
        grown.push_back({&finalists[distinct[k]], std::move(one.pair), one.score});
    }
  sortByScore(grown);
  grown.resize(std::min(MOST_GROWN, grown.size()));
  std::vector<std::optional<Finalist>> better(grown.size());
  parallelFor(static_cast<int>(grown.size()), [&](int i) {
    auto& [from, pair, score] = grown[i];
    const std::optional<MapScore> less = letGo(source, target, softness, SCORE_NOISE, pair);
    better[i] = withMap(source, target, std::move(pair), less.value_or(score), *from);
  });
  return joined(std::move(better), std::move(finalists));
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
      mixed[i] = bend(source, target, STARTS.back(), mixed[i]);
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
    finalists.front().maps = mixed[best];
    finalists.front().score = scores[best];
  }
}

}  // namespace posture
