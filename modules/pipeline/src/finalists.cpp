// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "finalists.h"

#include <posture/core/parallel.h>
#include <posture/refine/bend.h>
#include <posture/refine/tip_maps.h>
#include <posture/refine/turn_limbs.h>

#include <algorithm>
#include <iterator>
#include <memory>
#include <utility>

namespace posture {
namespace {

/// Right candidates have 0.38 and more, mirrored ones -0.35 and less; between them are maps that
/// are torn, which are no use either.
constexpr double LEAST_ORIENTATION = 0.2;

constexpr int MOST_FINALISTS = 8, MOST_LAID = 4;

/// So many are bent further, so often at most.
constexpr int BENT_FURTHER = 16, MOST_FURTHER = 4;

/// Where the sample maps end.
constexpr int CANDIDATE_BASIS = 36;

/// The low start mends limbs turned inside out, the high one keeps those a low one would twist.
const std::vector<std::vector<int>> STARTS{{12, 24, 36, 48, 60}, {30, 40, 50, 60}};

const std::vector<int> FINE_SIZES{40, 58, 76, 95, 114, 133, 152, 171, 190};

/// A soft surface slides far, a stiff one keeps what is known: which of the two ways down is better
/// depends on how isometric the pair is, and the score tells. The longer way first: two threads
/// then end at the same time.
const std::vector<std::vector<double>> STIFFENINGS{{0.03, 0.1, 0.3, 1}, {0.1, 0.3, 1}};
constexpr int ROUNDS = 6;

/// How many turns of a limb are tried on the work meshes, and how all settles then to be compared.
constexpr std::size_t MOST_TURNS = 2;
const std::vector<double> QUICKLY{0.3, 1};

/// What turned limbs must gain of the score: those that changed it by less were as often wrong as
/// right.
constexpr double LEAST_GAIN = 0.03;

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
  std::vector<std::vector<int>> parts;
  for (int start = 0; start < n; ++start) {
    if (!open[start]) continue;
    std::vector<int> part{start};
    open[start] = 0;
    for (std::size_t i = 0; i < part.size(); ++i)
      for (const int* w = source.neighbors.begin(part[i]); w != source.neighbors.end(part[i]); ++w)
        if (open[*w]) {
          open[*w] = 0;
          part.push_back(*w);
        }
    if (static_cast<int>(part.size()) >= LEAST_PART && 2 * static_cast<int>(part.size()) <= n)
      parts.push_back(std::move(part));
  }
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

/// Maps of the coarse meshes on the work meshes, through larger and larger bases.
BentPair sharpened(const Eigen::MatrixXf& coarse_functions,
                   const SpectralSurface& source,
                   const Eigen::MatrixXf& target_coarse_functions,
                   const SpectralSurface& target,
                   const VertexMaps& maps) {
  const VertexMaps start = spreadToVertices(source,
                                            target,
                                            coarse_functions,
                                            target_coarse_functions,
                                            {maps.forward, maps.backward, 0},
                                            STARTS.front().back());
  const VertexMaps sharp = sharpen(source, target, FINE_SIZES, start);
  return {sharp,
          target.mesh.vertices(sharp.forward, Eigen::all),
          source.mesh.vertices(sharp.backward, Eigen::all)};
}

/// The work meshes of the target and of the source at each finalist's scale, most of which are 1.
class WorkSurfaces {
 public:
  WorkSurfaces(const RefinedShape& source,
               const RefinedShape& target,
               const std::vector<const Finalist*>& finalists) {
    for (const Finalist* finalist : finalists)
      if (std::find(scales_.begin(), scales_.end(), finalist->scale) == scales_.end())
        scales_.push_back(finalist->scale);
    surfaces_.resize(1 + scales_.size());
    parallelFor(static_cast<int>(surfaces_.size()), [&](int i) {
      const RefinedShape shape = i == 0 ? target : rescaled(source, scales_[i - 1]);
      surfaces_[i] = std::make_unique<const SpectralSurface>(shape.workSurface());
    });
  }

  const SpectralSurface& target() const { return *surfaces_[0]; }
  const SpectralSurface& source(double scale) const {
    const auto found = std::find(scales_.begin(), scales_.end(), scale);
    return *surfaces_[1 + (found - scales_.begin())];
  }

 private:
  std::vector<double> scales_;
  std::vector<std::unique_ptr<const SpectralSurface>> surfaces_;  // the target's first
};

template <class Scored>
void sortByScore(std::vector<Scored>& maps) {
  std::stable_sort(maps.begin(), maps.end(), [](const Scored& a, const Scored& b) {
    return a.score.total() < b.score.total();
  });
}

/// What of the work meshes' map the coarse meshes hold.
BentPair onCoarse(const RefinedShape& source, const RefinedShape& target, const BentPair& pair) {
  const auto matches =
      [](const ReducedMesh& from, const std::vector<int>& map, const ReducedMesh& to) {
        std::vector<int> coarse;
        for (int v : from.vertex) coarse.push_back(to.nearest[map[v]]);
        return coarse;
      };
  return {{matches(source.coarse, pair.maps.forward, target.coarse),
           matches(target.coarse, pair.maps.backward, source.coarse)},
          pair.bent_a(source.coarse.vertex, Eigen::all),
          pair.bent_b(target.coarse.vertex, Eigen::all)};
}

/// A map with the limbs turned about themselves that fit clearly better so. Which turns are worth
/// trying is seen on the coarse meshes; each limb is turned alone, and then together all for which
/// the score was better.
RefinedMap withLimbsTurned(const RefinedShape& source,
                           const RefinedShape& target,
                           const SpectralSurface& source_work,
                           const SpectralSurface& target_work,
                           RefinedMap map) {
  const SpectralSurface source_coarse = source.coarseSurface(),
                        target_coarse = target.coarseSurface();
  const BentPair coarse = onCoarse(source, target, map.pair);
  const double softness = settlingSoftness(source_work.eigenvalues, target_work.eigenvalues);
  const std::vector<int> tips = tipsOf(source.samples);
  std::vector<std::vector<LimbTurn>> turns(tips.size());
  const auto vertex = [&](int limb) { return source.sample_vertex[tips[limb]]; };
  const auto withTurns = [&](const std::vector<int>& limbs, const std::vector<double>& shares) {
    RefinedMap turned = map;
    bool any = false;
    for (int i : limbs)
      any |= turnLimb(source_work, target_work, vertex(i), softness, turns[i], turned.pair);
    if (!any) return turned;
    for (double share : shares)
      settle(source_work, target_work, share * softness, ROUNDS, turned.pair);
    turned.score = scoreMaps(source_work, target_work, turned.pair.maps);
    return turned;
  };
  std::vector<char> gains(tips.size(), 0);
  parallelFor(static_cast<int>(tips.size()), [&](int i) {
    turns[i] = likelyTurns(source_coarse,
                           target_coarse,
                           source.coarse.nearest[vertex(i)],
                           softness,
                           coarse,
                           MOST_TURNS);
    gains[i] = withTurns({i}, QUICKLY).score.total() < map.score.total();
  });
  std::vector<int> limbs;
  for (std::size_t i = 0; i < gains.size(); ++i)
    if (gains[i] != 0) limbs.push_back(static_cast<int>(i));
  if (limbs.empty()) return map;
  RefinedMap turned = withTurns(limbs, STIFFENINGS.front());
  return turned.score.total() < map.score.total() - LEAST_GAIN ? turned : map;
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
    finalist.score = scoreLaid(scaled, target, *finalist.bent);
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

std::vector<RefinedMap> refineFinalists(const RefinedShape& source,
                                        const RefinedShape& target,
                                        const std::vector<const Finalist*>& finalists) {
  const WorkSurfaces surfaces(source, target, finalists);
  const SpectralSurface& target_work = surfaces.target();
  std::vector<BentPair> starts(finalists.size());
  parallelFor(static_cast<int>(finalists.size()), [&](int i) {
    const Finalist& finalist = *finalists[i];
    const RefinedShape scaled = rescaled(source, finalist.scale);
    starts[i] = finalist.bent ? carryUp(scaled.work.mesh,
                                        scaled.coarse,
                                        BendableSurface(scaled.coarse.mesh),
                                        target.work.mesh,
                                        target.coarse,
                                        BendableSurface(target.coarse.mesh),
                                        *finalist.bent)
                              : sharpened(scaled.coarseFunctions(),
                                          surfaces.source(finalist.scale),
                                          target.coarseFunctions(),
                                          target_work,
                                          finalist.maps);
  });
  std::vector<RefinedMap> refined(finalists.size() * STIFFENINGS.size());
  parallelFor(static_cast<int>(refined.size()), [&](int i) {
    RefinedMap& map = refined[i];
    map.finalist = i / static_cast<int>(STIFFENINGS.size());
    map.scale = finalists[map.finalist]->scale;
    map.laid = finalists[map.finalist]->bent.has_value();
    map.pair = starts[map.finalist];
    const SpectralSurface& work = surfaces.source(map.scale);
    const double softness = settlingSoftness(work.eigenvalues, target_work.eigenvalues);
    for (double share : STIFFENINGS[i % STIFFENINGS.size()])
      settle(work, target_work, share * softness, ROUNDS, map.pair);
    map.score = map.laid ? scoreLaid(work, target_work, map.pair)
                         : scoreMaps(work, target_work, map.pair.maps);
  });
  sortByScore(refined);
  if (refined.empty() || refined.front().laid) return refined;
  RefinedMap& best = refined.front();
  // Its rivals are not turned: what it is compared by stays as it was.
  const MapScore judged = best.score;
  best = withLimbsTurned(
      rescaled(source, best.scale), target, surfaces.source(best.scale), target_work, best);
  best.score = judged;
  return refined;
}

double settlingSoftness(const Vector& eigenvalues_a, const Vector& eigenvalues_b) {
  const auto k = std::min(eigenvalues_a.size(), eigenvalues_b.size());
  return 0.5 * (eigenvalues_a[k - 1] + eigenvalues_b[k - 1]);
}

}  // namespace posture
