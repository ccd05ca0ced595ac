// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "refined/refinement/judge_by_ends.h"

#include <posture/refine/rigid_ends.h>

#include "answer/verdict.h"
#include "refined/finalists/answer_gap.h"
#include <algorithm>

namespace posture {
namespace {

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

/// Those that were not let go of, nor what they are matched with.
std::vector<int> matchedTips(const std::vector<int>& tips,
                             const std::vector<char>& apart,
                             const std::vector<int>& map,
                             const std::vector<char>& apart_there) {
  std::vector<int> matched;
  for (int tip : tips)
    if (!isApart(apart, tip) && !isApart(apart_there, map[tip])) matched.push_back(tip);
  return matched;
}

double handsCostOf(const RefinedShape& source,
                   const RefinedShape& target,
                   const WorkSurfaces& surfaces,
                   const RefinedMap& map) {
  const BentPair& pair = map.pair;
  const HandVote vote =
      handVote(surfaces.source(map.scale),
               surfaces.target(),
               matchedTips(source.tips(), pair.apart_a, pair.maps.forward, pair.apart_b),
               matchedTips(target.tips(), pair.apart_b, pair.maps.backward, pair.apart_a),
               pair.maps);
  return costOfHands(vote.for_it, vote.against_it);
}

/// Which answer each map gives, and the best map of each.
struct Answers {
  std::vector<const RefinedMap*> best;
  std::vector<std::size_t> of_map;
};

Answers answersOf(const std::vector<RefinedMap>& maps, const TriangleMesh& target, double gap) {
  Answers answers;
  for (const RefinedMap& map : maps) {
    const auto known =
        std::find_if(answers.best.begin(), answers.best.end(), [&](const RefinedMap* other) {
          return gapBetween(target, map.pair, other->pair) <= gap;
        });
    answers.of_map.push_back(known - answers.best.begin());
    if (known == answers.best.end()) answers.best.push_back(&map);
  }
  return answers;
}

}  // namespace

void judgeByEnds(const RefinedShape& source,
                 const RefinedShape& target,
                 const WorkSurfaces& surfaces,
                 bool may_lack,
                 std::vector<RefinedMap>& maps) {
  const double gap = answerGap(target.samples);
  const Answers answers = answersOf(maps, surfaces.target().mesh, gap);
  std::vector<double> ends(answers.best.size(), 0), hands = ends;
  if (answers.best.size() > 1)
    ends = disagreementsOfEnds(source, target, surfaces, answers.best, gap);
  if (may_lack)
    for (std::size_t k = 0; k < hands.size(); ++k)
      hands[k] = handsCostOf(source, target, surfaces, *answers.best[k]);
  for (std::size_t i = 0; i < maps.size(); ++i) {
    maps[i].ends = ends[answers.of_map[i]];
    maps[i].hands = hands[answers.of_map[i]];
  }
  std::stable_sort(maps.begin(), maps.end(), [](const RefinedMap& a, const RefinedMap& b) {
    return a.judged() < b.judged();
  });
}

}  // namespace posture
