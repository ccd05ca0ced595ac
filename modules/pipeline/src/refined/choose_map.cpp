// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "refined/choose_map.h"

#include <posture/refine/let_go.h>

#include "answer/verdict.h"
#include "refined/finalists/answer_gap.h"
#include "refined/finalists/distinct_finalists.h"
#include "refined/refinement/refined_answers.h"
#include "refined/refinement/refined_pictures.h"
#include "refined/refinement/refined_result.h"
#include "refined/work/coarse_map.h"
#include "refined/work/refined_shape.h"
#include "sides/parts_like.h"
#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

namespace posture {
namespace {

/// Where there are as many: the answers that were refined, and the best of the others.
constexpr std::size_t LEAST_ALTERNATIVES = 4;

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

/// Whether a side may lack what the other one has.
bool mayLack(const PosedSide& source, const PosedSide& target) {
  const auto open = [](const PosedSide& side) {
    return side.given.is_patched || mayBePiece(side.ordered);
  };
  return open(source) || open(target);
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

/// The leading finalists, as precise as the work meshes allow; the best first.
std::vector<RefinedMap> refineLeading(const RefinedShape& source,
                                      const RefinedShape& target,
                                      bool may_lack,
                                      const std::vector<Finalist>& finalists,
                                      const std::vector<int>& distinct) {
  const std::vector<int> leading = leadingOf(finalists, distinct);
  std::vector<const Finalist*> chosen;
  chosen.reserve(leading.size());
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

}  // namespace

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
    const std::vector<int>& remaining = refined_answers.remaining();
    std::vector<int> compared;  // on the work meshes: these are what trust is told by
    std::copy_if(remaining.begin(), remaining.end(), std::back_inserter(compared), [&](int answer) {
      return refined_answers.of(answer) != nullptr;
    });
    const std::vector<int> answers = foremost(remaining, compared, LEAST_ALTERNATIVES);
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

}  // namespace posture
