// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "refined/refinement/refined_maps.h"

#include <posture/core/parallel.h>
#include <posture/refine/bend.h>
#include <posture/refine/carry_up.h>
#include <posture/refine/let_go.h>
#include <posture/refine/settle.h>
#include <posture/refine/turn_limbs.h>

#include "refined/finalists/by_score.h"
#include "refined/refinement/judge_by_ends.h"
#include "refined/refinement/work_surfaces.h"
#include <algorithm>
#include <optional>
#include <utility>

namespace posture {
namespace {

/// Ways to settle: softening, before that still stiffer, or the end of softening alone. A stiff
/// surface slides far as a whole, a soft one stays near what is known: which of the first two ways
/// is better depends on how isometric the pair is, and the score tells. The longer way first: two
/// threads then end at the same time.
enum Way { STIFF, SOFT, QUICK };
constexpr int WAYS = 2;           // that are compared
constexpr double STIFFER = 0.03;  // of the softness

/// How many turns of a limb are tried on the work meshes; to be compared, all settles quickly then.
constexpr std::size_t MOST_TURNS = 2;

/// What turned limbs must gain of the score: those that changed it by less were as often wrong as
/// right.
constexpr double LEAST_GAIN = 0.03;

/// What letting go must gain of the score each time, as it takes places out of the map. Where a
/// limb was squeezed 0.25 and more were gained; a scan of a horse gained 0.18 by the loss of places
/// that were right.
constexpr double LEAST_OF_LETTING_GO = 2 * SCORE_NOISE;

/// What letting go must gain for a map to be judged without what it squeezes. A map whose score is
/// higher by so much is e times less likely to be right. On cut bodies maps gained either 1.2 and
/// more or at most 0.7.
constexpr double LEAST_TO_JUDGE_WITHOUT = 1;

void settleBy(Way way,
              double softness,
              const SpectralSurface& source,
              const SpectralSurface& target,
              BentPair& pair) {
  if (way == STIFF) settle(source, target, STIFFER * softness, SETTLING_ROUNDS, pair);
  settleSoftening(source, target, softness, pair, way == QUICK ? 1 : 0);
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
                                            FINALIST_BASIS);
  const VertexMaps sharp =
      sharpen(source, target, {40, 58, 76, 95, 114, 133, 152, 171, 190}, start);
  return {sharp,
          target.mesh.vertices(sharp.forward, Eigen::all),
          source.mesh.vertices(sharp.backward, Eigen::all)};
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
/// the score was better, or the best of them where they do not go together.
RefinedMap withLimbsTurned(const RefinedShape& source,
                           const RefinedShape& target,
                           const SpectralSurface& source_work,
                           const SpectralSurface& target_work,
                           RefinedMap map) {
  const SpectralSurface source_coarse = source.coarseSurface(),
                        target_coarse = target.coarseSurface();
  const BentPair coarse = onCoarse(source, target, map.pair);
  const double softness = settlingSoftness(source_work, target_work);
  const std::vector<int> tips = source.tips();
  std::vector<std::vector<LimbTurn>> turns(tips.size());
  const auto withTurns = [&](const std::vector<int>& limbs, Way way) {
    RefinedMap turned = map;
    bool any = false;
    for (int i : limbs)
      any |= turnLimb(source_work, target_work, tips[i], softness, turns[i], turned.pair);
    if (!any) return turned;
    settleBy(way, softness, source_work, target_work, turned.pair);
    turned.score = scoreMaps(source_work, target_work, turned.pair.maps);
    return turned;
  };
  std::vector<double> gains(tips.size(), 0);
  parallelFor(static_cast<int>(tips.size()), [&](int i) {
    try {
      turns[i] = likelyTurns(source_coarse,
                             target_coarse,
                             source.coarse.nearest[tips[i]],
                             softness,
                             coarse,
                             MOST_TURNS);
      gains[i] = map.score.total() - withTurns({i}, QUICK).score.total();
    } catch (const TornSurface&) {  // the others may turn
    }
  });
  std::vector<int> limbs;
  for (std::size_t i = 0; i < gains.size(); ++i)
    if (gains[i] > 0) limbs.push_back(static_cast<int>(i));
  if (limbs.empty()) return map;
  const auto fitsBetter = [&](const RefinedMap& turned) {
    return turned.score.total() < map.score.total() - LEAST_GAIN;
  };
  RefinedMap turned = withTurns(limbs, STIFF);
  if (limbs.size() > 1 && !fitsBetter(turned)) {
    const int best = *std::max_element(
        limbs.begin(), limbs.end(), [&](int i, int j) { return gains[i] < gains[j]; });
    turned = withTurns({best}, STIFF);
  }
  return fitsBetter(turned) ? turned : map;
}

/// Changes a map; where a surface is too torn to be bent on, the map stays as it is.
template <class Change>
void changeUnlessTorn(RefinedMap& map, const Change& change) {
  try {
    RefinedMap changed = map;
    change(changed);
    map = std::move(changed);
  } catch (const TornSurface&) {
  }
}

/// Lets go of what a map squeezes so badly that its score says nothing of the rest: a hand that the
/// other side lacks, drawn over the whole arm. Maps that take stumps to stumps have no such place,
/// right or wrong. What settling alone gains does not count.
void letGoOfWhatIsSqueezed(const SpectralSurface& source,
                           const SpectralSurface& target,
                           double softness,
                           RefinedMap& map) {
  BentPair loose = map.pair, settled = map.pair;
  const auto score = letGo(source, target, softness, LEAST_OF_LETTING_GO, loose);
  const auto isWorth = [&](double before) {
    return score && score->total() < before - LEAST_TO_JUDGE_WITHOUT;
  };
  if (!isWorth(map.score.total())) return;
  settleBy(SOFT, softness, source, target, settled);
  if (!isWorth(scoreBent(source, target, settled, false).total())) return;
  if (orientation(source, target, loose.maps) <= LEAST_ORIENTATION) return;
  map.pair = std::move(loose);
  map.score = *score;
}

/// Annealed; ends of limbs that then do not fit laid anew, one after the other, and all annealed
/// again each time, where the limb then lies better.
void annealWithEndsRefitted(const RefinedShape& source,
                            const SpectralSurface& source_work,
                            const SpectralSurface& target_work,
                            BentPair& pair) {
  const double softness = settlingSoftness(source_work, target_work);
  anneal(source_work, target_work, softness, pair);
  bool is_settled = false;
  for (int tip : source.tips()) {
    if (isApart(pair.apart_a, tip) || isApart(pair.apart_b, pair.maps.forward[tip])) continue;
    try {
      BentPair refitted = pair;
      if (!refitLimbEnd(source_work, target_work, tip, softness, refitted)) continue;
      anneal(source_work, target_work, softness, refitted);
      if (!limbFitsBetter(source_work, target_work, tip, softness, pair, refitted)) continue;
      pair = std::move(refitted);
      is_settled = true;
    } catch (const TornSurface&) {  // the others may be laid anew
    }
  }
  if (!is_settled) anneal(source_work, target_work, softness, pair);
}

}  // namespace

std::vector<RefinedMap> refineFinalists(const RefinedShape& source,
                                        const RefinedShape& target,
                                        bool may_lack,
                                        const std::vector<const Finalist*>& finalists) {
  const WorkSurfaces surfaces(source, target, finalists);
  const SpectralSurface& target_work = surfaces.target();
  std::vector<BentPair> starts(finalists.size());
  parallelFor(static_cast<int>(finalists.size()), [&](int i) {
    const Finalist& finalist = *finalists[i];
    const RefinedShape scaled = rescaled(source, finalist.scale);
    starts[i] =
        finalist.bent
            ? carryUp(
                  scaled.work.mesh, scaled.coarse, target.work.mesh, target.coarse, *finalist.bent)
            : sharpened(scaled.coarseFunctions(),
                        surfaces.source(finalist.scale),
                        target.coarseFunctions(),
                        target_work,
                        finalist.maps);
  });
  std::vector<std::optional<RefinedMap>> settled(finalists.size() * WAYS);
  parallelFor(static_cast<int>(settled.size()), [&](int i) {
    const Finalist& finalist = *finalists[i / WAYS];
    RefinedMap map;
    map.finalist = i / WAYS;
    map.scale = finalist.scale;
    map.found = {finalist.laid, may_lack};
    map.pair = starts[map.finalist];
    const SpectralSurface& work = surfaces.source(map.scale);
    const double softness = settlingSoftness(work, target_work);
    try {
      settleBy(static_cast<Way>(i % WAYS), softness, work, target_work, map.pair);
    } catch (const TornSurface&) {  // the others may settle
      return;
    }
    map.score = finalist.bent ? scoreBent(work, target_work, map.pair, map.found.laid)
                              : scoreMaps(work, target_work, map.pair.maps);
    if (may_lack && !map.found.laid)
      changeUnlessTorn(map, [&](RefinedMap& loose) {
        letGoOfWhatIsSqueezed(work, target_work, softness, loose);
      });
    settled[i] = std::move(map);
  });
  std::vector<RefinedMap> refined;
  for (std::optional<RefinedMap>& map : settled)
    if (map) refined.push_back(std::move(*map));
  if (refined.empty()) throw TornSurface("a surface is too torn to settle on the other");
  sortByScore(refined);
  judgeByEnds(source, target, surfaces, may_lack, refined);
  return refined;
}

void annealMap(const RefinedShape& source,
               const RefinedShape& target,
               bool may_lack,
               RefinedMap& map) {
  if (map.found.laid) return;
  const MapScore judged = map.score;
  const RefinedShape scaled = rescaled(source, map.scale);
  const SpectralSurface source_work = scaled.workSurface(), target_work = target.workSurface();
  changeUnlessTorn(map, [&](RefinedMap& turned) {
    if (map.pair.apart_a.empty() && map.pair.apart_b.empty())
      turned = withLimbsTurned(scaled, target, source_work, target_work, map);
  });
  changeUnlessTorn(map, [&](RefinedMap& annealed) {
    annealWithEndsRefitted(scaled, source_work, target_work, annealed.pair);
  });
  if (may_lack)
    changeUnlessTorn(map, [&](RefinedMap& less) {
      const double softness = settlingSoftness(source_work, target_work);
      if (letGo(source_work, target_work, softness, LEAST_OF_LETTING_GO, less.pair))
        anneal(source_work, target_work, softness, less.pair);
    });
  map.score = judged;
}

}  // namespace posture
