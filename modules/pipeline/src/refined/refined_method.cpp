// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "refined/refined_method.h"

#include <posture/core/error.h>
#include <posture/core/parallel.h>
#include <posture/mesh/corners.h>
#include <posture/refine/let_go.h>

#include "answer/verdict.h"
#include "refined/finalists/answer_gap.h"
#include "refined/finalists/distinct_finalists.h"
#include "refined/finalists/extended_finalist.h"
#include "refined/finalists/find_finalists.h"
#include "refined/finish_map.h"
#include "refined/refinement/refined_answers.h"
#include "refined/refinement/refined_maps.h"
#include "refined/refinement/refined_pictures.h"
#include "refined/refinement/refined_result.h"
#include "refined/work/coarse_map.h"
#include "refined/work/posed_side.h"
#include "refined/work/refined_shape.h"
#include "sides/parts_like.h"
#include "sides/pose.h"
#include <algorithm>
#include <memory>
#include <utility>

namespace posture {
namespace {

constexpr int POOL = 32;
constexpr std::size_t MOST_ALTERNATIVES = 4;

/// What refining finalists takes of the time of a run.
constexpr double REFINEMENT = 0.14;

AlternativeSummary summarize(const Finalist& finalist) {
  AlternativeSummary summary;
  summary.orientation = finalist.orientation;
  summary.bending = finalist.score.bending;
  summary.curvature = finalist.score.curvature;
  summary.distortion = finalist.score.distortion;
  summary.return_miss = finalist.score.return_miss;
  summary.let_go = finalist.score.let_go;
  summary.score = finalist.score.total();
  return summary;
}

ShapeSummary summarize(const GivenShape& given, const RefinedShape& shape) {
  ShapeSummary summary = summarize(given);
  summary.added_vertices = static_cast<int>(shape.full.vertices.rows()) - summary.clean_vertices;
  summary.samples = static_cast<int>(shape.samples.form.rows());
  summary.stress = shape.stress;
  return summary;
}

/// How many vertices a side counts as where the other one is reduced. The same for a side, its
/// parts and with its holes closed, so that scores of all can be compared, and however often the
/// file has a vertex.
int vertexCount(const GivenShape& given, const RefinedShape& shape) {
  return shape.parts.empty() ? cornerPlaces(given.input, given.ownVertices())
                             : static_cast<int>(shape.full.vertices.rows());
}

/// Evenly spread subsets of the vertices: all with all can be compared on them. A source much
/// coarser than the target gets more vertices first.
void reduceSides(PosedSide& source, PosedSide& target) {
  const TriangleMesh source_surface = posed(source.ordered.mesh, source.pose),
                     target_surface = posed(target.ordered.mesh, target.pose);
  source.shape = fullSide("source", source_surface, isMuchCoarser(source_surface, target_surface));
  target.shape = fullSide("target", target_surface, false);
  parallelFor(2, [&](int side) {
    if (side == 0) reduceSide("source", vertexCount(target.given, target.shape), source.shape);
    if (side == 1) reduceSide("target", vertexCount(source.given, source.shape), target.shape);
  });
}

/// Whether a side may lack what the other one has.
bool mayLack(const PosedSide& source, const PosedSide& target) {
  const auto open = [](const PosedSide& side) {
    return side.given.patch_vertices > 0 || mayBePiece(side.ordered);
  };
  return open(source) || open(target);
}

/// The leading finalists, as precise as the work meshes allow; the best first.
std::vector<RefinedMap> refineLeading(const RefinedShape& source,
                                      const RefinedShape& target,
                                      bool may_lack,
                                      const std::vector<Finalist>& finalists,
                                      const std::vector<int>& distinct) {
  const std::vector<int> leading = leadingOf(finalists, distinct);
  std::vector<const Finalist*> chosen;
  for (int i : leading) chosen.push_back(&finalists[i]);
  std::vector<RefinedMap> maps = refineFinalists(source, target, may_lack, chosen);
  for (RefinedMap& map : maps) map.finalist = leading[map.finalist];
  return maps;
}

/// What there was to choose from, as far as it is known before the final map.
std::vector<AlternativeSummary> summarizeAnswers(const PosedSide& source,
                                                 const PosedSide& target,
                                                 const TriangleMesh& coarse_target,
                                                 const std::vector<Finalist>& finalists,
                                                 const std::vector<int>& answers,
                                                 const RefinedAnswers& refined) {
  std::vector<AlternativeSummary> summaries;
  for (int i : answers) {
    AlternativeSummary summary = summarize(finalists[i]);
    if (const RefinedMap* map = refined.of(i)) summary.refined_score = map->judged();
    summary.gap = gapBetween(coarse_target, finalists[refined.chosen()].maps, finalists[i].maps);
    summary.target_vertex =
        coarseToInput(finalists[i].maps, source.given, source.shape, target.given, target.shape);
    summaries.push_back(std::move(summary));
  }
  return summaries;
}

/// What is there once surfaces are bent onto each other: the first maps, between the coarse ones.
struct FirstMaps {
  FirstMaps(const GivenShape& source, const GivenShape& target)
      : chosen(std::make_shared<ChosenMap>(source, target)) {}

  std::shared_ptr<ChosenMap> chosen;
  std::unique_ptr<const SpectralSurface> source_coarse, target_coarse;
  std::vector<Finalist> bent;

  /// Brings both sides to one scale.
  void scale(double ratio) {
    chosen->source.scale(ratio);
    source_coarse = std::make_unique<SpectralSurface>(chosen->source.shape.coarseSurface());
    target_coarse = std::make_unique<SpectralSurface>(chosen->target.shape.coarseSurface());
  }

  CoarseSides coarseSides() const {
    return {chosen->source, chosen->target, *source_coarse, *target_coarse};
  }
};

/// The surfaces as they are worked on; smooth functions on them, and samples.
FirstMaps preparedSides(const GivenShape& source_given,
                        const GivenShape& target_given,
                        StageClock& clock) {
  FirstMaps first(source_given, target_given);
  PosedSide &source = first.chosen->source, &target = first.chosen->target;
  clock.stage("reduction", 0.03, [&] { reduceSides(source, target); });

  // The smoothest functions on each surface, which do not change when it bends.
  clock.stage("spectrum", 0.09, [&] {
    parallelFor(2, [&](int side) {
      side == 0 ? addSpectrum("source", source.shape) : addSpectrum("target", target.shape);
    });
  });

  // Geodesic distances between samples, and their canonical forms (the paper's section 4.1).
  clock.stage("geodesic", 0.09, [&] {
    addSamples("source", source.shape);
    addSamples("target", target.shape);
  });
  clock.show([&] { return samplePictures(source.shape, target.shape); });
  return first;
}

/// Whether the best of the first maps is between poses of one body, but takes more of a side
/// amiss than those of whole bodies do (up to 0.045 of the area; 0.076 and more where a horse has
/// lost its lower legs): the other side lacks a part without a rim to show for it, as scans do
/// that were closed, and rid of their pieces.
bool misplacesALimb(const FirstMaps& first) {
  constexpr double MOST_MISPLACED = 0.06;
  if (first.bent.empty() || !convinces(first.bent.front().score.total())) return false;
  const VertexMaps& maps = first.bent.front().maps;
  const SpectralSurface &source = *first.source_coarse, &target = *first.target_coarse;
  return areaShare(source, misplaced(source, target, maps.forward, {})) > MOST_MISPLACED ||
         areaShare(target, misplaced(target, source, maps.backward, {})) > MOST_MISPLACED;
}

/// The way from the surfaces to the first maps.
FirstMaps firstMaps(const GivenShape& source_given,
                    const GivenShape& target_given,
                    StageClock& clock) {
  FirstMaps first = preparedSides(source_given, target_given, clock);
  const PosedSide &source = first.chosen->source, &target = first.chosen->target;

  // Maps between the samples: all axis orders and signs, and what the shapes' symmetries make of
  // them.
  const std::vector<SampleMap> pool = clock.stage("candidates", 0.08, [&] {
    return poolOfMaps(source.shape.samples, target.shape.samples, POOL);
  });

  // With holes the areas do not tell the scale, but distances under a map do; those under a
  // mirrored one as well.
  first.scale(distanceRatio(source.shape.samples, target.shape.samples, pool.front()));
  first.bent = bentFinalists(first.coarseSides(), pool, clock);
  return first;
}

/// Chooses a map: the way from finalists, by increasing score, to the best of the refined ones.
void chooseAmong(const FirstMaps& first_maps, std::vector<Finalist> found, StageClock& clock) {
  ChosenMap& chosen = *first_maps.chosen;
  PosedSide &source = chosen.source, &target = chosen.target;
  const SpectralSurface &source_coarse = *first_maps.source_coarse,
                        &target_coarse = *first_maps.target_coarse;
  chosen.finalists = std::move(found);
  const std::vector<Finalist>& finalists = chosen.finalists;
  RegistrationResult& result = chosen.result;
  result.source = summarize(source.given, source.shape);
  result.target = summarize(target.given, target.shape);
  if (finalists.empty()) {
    result.scale = source.pose.unit / target.pose.unit;
    leaveWhereItIs(source.given.input.vertices, result);
    return;
  }
  const double gap = answerGap(target.shape.samples);
  const std::vector<int> distinct = distinctFinalists(finalists, target_coarse.mesh, gap);
  clock.show([&] { return finalistPictures(source_coarse, target_coarse, finalists, distinct); });

  // The best of the leading ones wins.
  clock.stage("refinement", REFINEMENT, [&] {
    const std::vector<RefinedMap> refined =
        refineLeading(source.shape, target.shape, chosen.may_lack, finalists, distinct);
    const RefinedAnswers refined_answers(
        refined, finalists, distinct, target_coarse.mesh, target.shape.work.mesh, gap);
    chosen.best = refined.front();
    const std::vector<int> answers =
        foremost(refined_answers.remaining(), refined_answers.chosen(), MOST_ALTERNATIVES);
    source.pose.unit *= chosen.best.scale;  // its shape stays: other answers have other scales
    result.scale = source.pose.unit / target.pose.unit;
    result.alternatives =
        summarizeAnswers(source, target, target_coarse.mesh, finalists, answers, refined_answers);
    for (int answer : answers) {
      const RefinedMap* map = refined_answers.of(answer);
      chosen.begun_from.push_back(map != nullptr ? map->finalist : answer);
    }
    const auto at = std::find(answers.begin(), answers.end(), refined_answers.chosen());
    result.chosen = static_cast<int>(at - answers.begin());
    result.score = chosen.best.likeness();
    result.hands = chosen.best.hands;
    setTrust(trustIn(result), result);
  });
}

/// Chooses a map: the way from the first ones to the best of the refined ones.
/// \return false: it stopped before maps are refined, as the known answer stands.
bool chooseMap(const FirstMaps& first_maps, const KnownAnswer& known, StageClock& clock) {
  ChosenMap& chosen = *first_maps.chosen;
  chosen.may_lack = mayLack(chosen.source, chosen.target) || misplacesALimb(first_maps);
  std::optional<std::vector<Finalist>> found =
      findFinalists(first_maps.coarseSides(), first_maps.bent, chosen.may_lack, known, clock);
  if (!found) {
    clock.skip(REFINEMENT);
    return false;
  }
  chooseAmong(first_maps, std::move(*found), clock);
  return true;
}

/// The way back where there is no map.
WayBack nothingBack(const GivenShape& target) {
  const auto n = target.input.vertices.rows();
  return {{std::vector<SurfacePoint>(n), Vector::Zero(n)}};
}

/// The attempt at the map that was chosen.
Attempt attemptAt(const std::shared_ptr<ChosenMap>& chosen,
                  const RegistrationOptions& options,
                  StageClock& clock) {
  Attempt attempt{chosen->result, {}};
  if (chosen->result.chosen < 0) {
    if (options.both_ways) attempt.found.back = nothingBack(chosen->target.given);
    return attempt;
  }
  if (!options.refine_alternatives) chosen->finalists = {};
  attempt.found.correspondence = roughCorrespondenceOf(chosen->source.given,
                                                       chosen->source.shape,
                                                       chosen->target.given,
                                                       chosen->target.shape,
                                                       chosen->best);
  // One attempt is finished, two with alternatives; those that are not foreseen count for nothing.
  StageClock::Label label = clock.label();
  label.portion = label.portion == 0 ? 0 : options.refine_alternatives ? 0.5 : 1;
  attempt.finish = [chosen, options, &clock, label] {
    return clock.within(label, [&] { return finishMap(*chosen, options, clock); });
  };
  return attempt;
}

}  // namespace

BegunAttempt beginAttempt(const GivenShape& source,
                          const GivenShape& target,
                          const RegistrationOptions& options,
                          StageClock& clock) {
  const auto first = std::make_shared<FirstMaps>(firstMaps(source, target, clock));
  BegunAttempt begun;
  if (!first->bent.empty()) begun.score = first->bent.front().score.total();
  begun.goOn = [first, options, &clock, label = clock.label()](const RegistrationResult* known,
                                                               bool may_stop) {
    require(first->chosen != nullptr, "BegunAttempt: gone on with twice");
    const FirstMaps maps = std::move(*first);
    return clock.within(label, [&]() -> std::optional<Attempt> {
      if (!chooseMap(maps, {known, may_stop}, clock)) return {};
      return attemptAt(maps.chosen, options, clock);
    });
  };
  return begun;
}

Attempt refinedMethod(const GivenShape& source,
                      const GivenShape& target,
                      const RegistrationOptions& options,
                      StageClock& clock) {
  return *beginAttempt(source, target, options, clock).goOn(nullptr, false);
}

Attempt extendedAnswer(const GivenShape& source,
                       const GivenShape& target,
                       const RegistrationResult& known,
                       const RegistrationOptions& options,
                       StageClock& clock) {
  FirstMaps first = preparedSides(source, target, clock);
  ChosenMap& chosen = *first.chosen;
  first.scale(known.scale * chosen.target.pose.unit / chosen.source.pose.unit);
  chosen.may_lack = true;
  Finalist extended =
      clock.stage("extending", 0, [&] { return extendedFinalist(first.coarseSides(), known); });
  chooseAmong(first, {std::move(extended)}, clock);
  chosen.result.score = chosen.best.score.totalOfPiece() + chosen.best.hands;
  setTrust(trustIn(chosen.result), chosen.result);
  return attemptAt(first.chosen, options, clock);
}

}  // namespace posture
