// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "refined_maps.h"

#include <posture/core/parallel.h>
#include <posture/refine/bend.h>
#include <posture/refine/let_go.h>
#include <posture/refine/rigid_ends.h>
#include <posture/refine/turn_limbs.h>

#include "answer_gap.h"
#include "by_score.h"
#include <algorithm>
#include <memory>
#include <stdexcept>
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
  const double softness = settlingSoftness(source_work.eigenvalues, target_work.eigenvalues);
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
    turns[i] = likelyTurns(
        source_coarse, target_coarse, source.coarse.nearest[tips[i]], softness, coarse, MOST_TURNS);
    gains[i] = map.score.total() - withTurns({i}, QUICK).score.total();
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

/// The tips that different answers take to different places.
std::vector<int> takenApart(const std::vector<int>& tips,
                            const TriangleMesh& other,
                            const std::vector<const std::vector<int>*>& maps,
                            double gap) {
  std::vector<int> apart;
  for (int tip : tips) {
    const auto place = [&](const std::vector<int>* map) { return other.vertices.row((*map)[tip]); };
    if (std::any_of(maps.begin(), maps.end(), [&](const std::vector<int>* map) {
          return (place(map) - place(maps.front())).norm() > gap;
        }))
      apart.push_back(tip);
  }
  return apart;
}

/// How much worse ends of limbs fit under each of several answers than under the others, the mean
/// of both ways.
std::vector<double> disagreementsOfEnds(const RefinedShape& source,
                                        const RefinedShape& target,
                                        const WorkSurfaces& surfaces,
                                        const std::vector<const RefinedMap*>& answers,
                                        double gap) {
  const SpectralSurface& target_work = surfaces.target();
  std::vector<const std::vector<int>*> forward, backward;
  for (const RefinedMap* map : answers) {
    forward.push_back(&map->pair.maps.forward);
    backward.push_back(&map->pair.maps.backward);
  }
  const std::vector<int> source_tips = takenApart(source.tips(), target_work.mesh, forward, gap),
                         target_tips = takenApart(target.tips(), source.work.mesh, backward, gap);
  std::vector<std::vector<EndFit>> there, back;
  for (const RefinedMap* map : answers) {
    const SpectralSurface& source_work = surfaces.source(map->scale);
    const VertexMaps& both = map->pair.maps;
    there.push_back(fitEnds(source_work, target_work, source_tips, both));
    back.push_back(fitEnds(target_work, source_work, target_tips, {both.backward, both.forward}));
  }
  std::vector<double> sums = endDisagreements(there);
  const std::vector<double> sums_back = endDisagreements(back);
  for (std::size_t k = 0; k < sums.size(); ++k) sums[k] = 0.5 * (sums[k] + sums_back[k]);
  const double least = *std::min_element(sums.begin(), sums.end());
  for (double& sum : sums) sum -= least;
  return sums;
}

/// Where maps are different answers, compares them by how ends of limbs fit, too: a body that is
/// half turned has each hand on the other one. A map that let go of an end which fits under another
/// one pays for it. Maps of one answer are judged by its best.
/// \param maps  by increasing score; the best first.
void judgeByEnds(const RefinedShape& source,
                 const RefinedShape& target,
                 const WorkSurfaces& surfaces,
                 std::vector<RefinedMap>& maps) {
  const double gap = answerGap(target.samples);
  std::vector<const RefinedMap*> answers;
  std::vector<std::size_t> answer_of;
  for (const RefinedMap& map : maps) {
    const auto known = std::find_if(answers.begin(), answers.end(), [&](const RefinedMap* other) {
      return gapBetween(surfaces.target().mesh, map.pair.maps, other->pair.maps) <= gap;
    });
    answer_of.push_back(known - answers.begin());
    if (known == answers.end()) answers.push_back(&map);
  }
  if (answers.size() < 2) return;
  const std::vector<double> ends = disagreementsOfEnds(source, target, surfaces, answers, gap);
  for (std::size_t i = 0; i < maps.size(); ++i) maps[i].ends = ends[answer_of[i]];
  std::stable_sort(maps.begin(), maps.end(), [](const RefinedMap& a, const RefinedMap& b) {
    return a.judged() < b.judged();
  });
}

/// Annealed, ends of limbs that then do not fit laid anew, and annealed again.
void annealWithEndsRefitted(const RefinedShape& source,
                            const SpectralSurface& source_work,
                            const SpectralSurface& target_work,
                            BentPair& pair) {
  const double softness = settlingSoftness(source_work.eigenvalues, target_work.eigenvalues);
  anneal(source_work, target_work, softness, pair);
  const auto isApart = [](const std::vector<char>& apart, int v) {
    return !apart.empty() && apart[v] != 0;
  };
  for (int tip : source.tips())
    if (!isApart(pair.apart_a, tip) && !isApart(pair.apart_b, pair.maps.forward[tip]))
      refitLimbEnd(source_work, target_work, tip, softness, pair);
  anneal(source_work, target_work, softness, pair);
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
  std::vector<RefinedMap> refined(finalists.size() * WAYS);
  parallelFor(static_cast<int>(refined.size()), [&](int i) {
    RefinedMap& map = refined[i];
    map.finalist = i / WAYS;
    map.scale = finalists[map.finalist]->scale;
    map.laid = finalists[map.finalist]->laid;
    map.pair = starts[map.finalist];
    const SpectralSurface& work = surfaces.source(map.scale);
    const double softness = settlingSoftness(work.eigenvalues, target_work.eigenvalues);
    settleBy(static_cast<Way>(i % WAYS), softness, work, target_work, map.pair);
    map.score = finalists[map.finalist]->bent ? scoreBent(work, target_work, map.pair, map.laid)
                                              : scoreMaps(work, target_work, map.pair.maps);
    if (!may_lack || map.laid) return;
    try {
      letGoOfWhatIsSqueezed(work, target_work, softness, map);
    } catch (const std::runtime_error&) {  // too torn to be bent on: it stays as it is
    }
  });
  sortByScore(refined);
  judgeByEnds(source, target, surfaces, refined);
  return refined;
}

void annealMap(const RefinedShape& source,
               const RefinedShape& target,
               bool may_lack,
               RefinedMap& map) {
  if (map.laid) return;
  const MapScore judged = map.score;
  const RefinedShape scaled = rescaled(source, map.scale);
  const SpectralSurface source_work = scaled.workSurface(), target_work = target.workSurface();
  if (map.pair.apart_a.empty() && map.pair.apart_b.empty())
    map = withLimbsTurned(scaled, target, source_work, target_work, map);
  annealWithEndsRefitted(scaled, source_work, target_work, map.pair);
  const double softness = settlingSoftness(source_work.eigenvalues, target_work.eigenvalues);
  map.score = judged;
  if (!may_lack) return;
  try {
    BentPair less = map.pair;
    if (!letGo(source_work, target_work, softness, LEAST_OF_LETTING_GO, less)) return;
    anneal(source_work, target_work, softness, less);
    map.pair = std::move(less);
  } catch (const std::runtime_error&) {  // too torn to be bent on: it stays as it is
  }
}

}  // namespace posture
