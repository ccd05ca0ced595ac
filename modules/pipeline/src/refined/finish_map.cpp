// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "refined/finish_map.h"

#include "answer/verdict.h"
#include "no_way_on.h"
#include "refined/completion/loose_pieces.h"
#include "refined/completion/target_pieces.h"
#include "refined/completion/way_back.h"
#include "refined/completion/whole_source.h"
#include "refined/finalists/answer_gap.h"
#include "refined/refinement/full_resolution.h"
#include "refined/refinement/refined_pictures.h"
#include "refined/refinement/refined_result.h"
#include "refined/work/refined_shape.h"
#include <algorithm>
#include <utility>
#include <vector>

namespace posture {
namespace {

/// Every vertex of the source a place, as isometric as the target allows (section 6.2).
/// \param scaled  the source at the scale of the map.
Points deformedInput(const PosedSide& source,
                     const RefinedShape& scaled,
                     const PosedSide& target,
                     const FullMap& full,
                     const OnPieces& on_pieces) {
  return target.pose.outOf(placesOfInput(source.given,
                                         scaled.full,
                                         std::vector<char>(full.places.size(), 1),
                                         placesOfWhole(source, scaled, target, full, on_pieces),
                                         source.pose.into(source.given.input.vertices)));
}

/// Takes an answer that was not chosen to full precision. Loose pieces have no counterparts in it:
/// they are placed by what is next to them in the one that was.
/// \throws NoWayOn  each way to refine it leads to the chosen one.
Correspondence refinedAlternative(const ChosenMap& chosen, int begun_from, double trust) {
  const PosedSide &source = chosen.source, &target = chosen.target;
  std::vector<RefinedMap> maps =
      refineFinalists(source.shape, target.shape, chosen.may_lack, {&chosen.finalists[begun_from]});
  const auto another = std::find_if(maps.begin(), maps.end(), [&](const RefinedMap& map) {
    return gapBetween(target.shape.work.mesh, map.pair, chosen.best.pair) >
           answerGap(target.shape.samples);
  });
  if (another == maps.end()) throw NoWayOn("an alternative leads where the chosen answer does");
  RefinedMap map = std::move(*another);
  annealMap(source.shape, target.shape, chosen.may_lack, map);
  Correspondence correspondence =
      correspondenceOf(source.given,
                       source.shape,
                       target.given,
                       target.shape,
                       toFullResolution(source.shape, target.shape, map),
                       trust);
  const CleanMesh& clean = source.given.clean;
  for (Eigen::Index v = 0; v < clean.offset.size(); ++v)
    if (!clean.isOnMain(v)) dropRow(correspondence, static_cast<std::size_t>(v));
  return correspondence;
}

/// What cannot be bent stays without.
void refineAlternatives(const ChosenMap& chosen, StageClock& clock, RegistrationResult& result) {
  for (std::size_t k = 0; k < result.alternatives.size(); ++k) {
    if (static_cast<int>(k) == result.chosen) continue;
    AlternativeSummary& other = result.alternatives[k];
    if (auto map = clock.tryTo([&] {
          return refinedAlternative(
              chosen, chosen.begun_from[k], result.trust * likelihoodOf(result, other));
        }))
      other.correspondence = std::move(*map);
  }
}

}  // namespace

RegistrationResult finishMap(const ChosenMap& chosen,
                             const RegistrationOptions& options,
                             StageClock& clock) {
  const PosedSide &source = chosen.source, &target = chosen.target;
  RegistrationResult result = chosen.result;
  const RefinedMap best = clock.stage("annealing", 0.08, [&] {
    RefinedMap map = chosen.best;
    annealMap(source.shape, target.shape, chosen.may_lack, map);
    return map;
  });
  clock.show([&] { return refinedPictures(source.shape, target.shape, best); });

  // All vertices, to a fraction of an edge.
  const FullMap full = clock.stage("full resolution", 0.05, [&] {
    FullMap map = toFullResolution(source.shape, target.shape, best);
    result.correspondence =
        correspondenceOf(source.given, source.shape, target.given, target.shape, map, result.trust);
    return map;
  });
  const RefinedShape scaled = rescaled(source.shape, best.scale);
  clock.stage("completion", 0.1, [&] {
    TargetOnSource back;
    if (options.both_ways || hasLoosePieces(target.given))
      back = targetOnSource(source, scaled, target, full, result.scale, result.trust);
    const OnPieces on_pieces = onPieces(source.given, target.given, back.target, back.pieces);
    LaidSide there{result.scale,
                   result.trust,
                   std::move(result.correspondence),
                   deformedInput(source, scaled, target, full, on_pieces)};
    addMatches(source.given, on_pieces, there);
    placeLoosePieces(source.given, target.given, there);
    result.correspondence = std::move(there.correspondence);
    result.deformed = std::move(there.deformed);
    if (options.both_ways) {
      result.back = WayBack{std::move(back.target.correspondence)};
      measureMiss(source.given, target.given.input, result.correspondence, *result.back);
    }
  });
  if (options.refine_alternatives)
    clock.stage("alternatives", 0.0, [&] { refineAlternatives(chosen, clock, result); });
  return result;
}

}  // namespace posture
