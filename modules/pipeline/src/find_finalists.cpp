// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "find_finalists.h"

#include <posture/refine/tip_maps.h>

#include "answers.h"
#include "attempts.h"
#include "by_score.h"
#include "changed_finalists.h"
#include "end_maps.h"
#include "refined_result.h"
#include "verdict.h"
#include <utility>

namespace posture {
namespace {

constexpr int MOST_TIP_MAPS = 8;

/// Whether an answer found otherwise is believed and the best finalist leads there too, wherever it
/// leads.
bool confirms(const RegistrationResult* known,
              const PosedSide& source,
              const PosedSide& target,
              const std::vector<Finalist>& finalists) {
  if (known == nullptr || !isDecided(*known) || finalists.empty()) return false;
  const Finalist& best = finalists.front();
  const std::vector<char> apart = best.bent ? best.bent->apart_a : std::vector<char>();
  const CleanMesh& clean = source.given.clean;
  const RefinedShape& shape = source.shape;
  const std::vector<int> places =
      coarseToInput(best.maps, source.given, shape, target.given, target.shape);
  std::vector<SurfacePoint> on_target(places.size());
  for (std::size_t v = 0; v < places.size(); ++v) {
    const int coarse = shape.coarse.nearest[shape.work.nearest[clean.clean_vertex[v]]];
    const bool is_mapped =
        clean.offset[static_cast<Eigen::Index>(v)] == 0 && !isApart(apart, coarse);
    if (is_mapped) on_target[v].vertex = places[v];
  }
  return agreeEverywhere(
      known->correspondence.on_target, on_target, target.given.input, 1 / target.pose.unit);
}

/// Finalists, and those that take tips of limbs to tips of limbs; then those that lay ends as they
/// fit.
std::vector<Finalist> withTips(const PosedSide& source_side,
                               const PosedSide& target_side,
                               const SpectralSurface& source,
                               const SpectralSurface& target,
                               double gap,
                               std::vector<Finalist> finalists) {
  const SampledShape &source_samples = source_side.shape.samples,
                     &target_samples = target_side.shape.samples;
  finalists = joined(std::move(finalists),
                     registerFinalists(source,
                                       target,
                                       source_samples,
                                       target_samples,
                                       tipMaps(source_samples, target_samples, MOST_TIP_MAPS)));
  bendFurther(source, target, finalists);
  exchangeParts(source, target, gap, finalists);
  const std::vector<SampleMap> maps = endMaps(source_side.shape,
                                              target_side.shape,
                                              source,
                                              target,
                                              finalists,
                                              distinctFinalists(finalists, target.mesh, gap));
  if (maps.empty()) return finalists;
  std::vector<Finalist> fitting =
      registerFinalists(source, target, source_samples, target_samples, maps);
  bendFurther(source, target, fitting);
  // Parts are exchanged with the best one before alone: with the others they have been.
  fitting.push_back(std::move(finalists.front()));
  finalists.erase(finalists.begin());
  sortByScore(fitting);
  exchangeParts(source, target, gap, fitting);
  return joined(std::move(finalists), std::move(fitting));
}

}  // namespace

std::vector<Finalist> bentFinalists(const SpectralSurface& source,
                                    const SpectralSurface& target,
                                    const SampledShape& source_samples,
                                    const SampledShape& target_samples,
                                    const std::vector<SampleMap>& pool,
                                    StageClock& clock) {
  // Those that keep the outside out, bent onto the target; the least strained first.
  return clock.stage("bending", 0.1, [&] {
    std::vector<Finalist> bent =
        registerFinalists(source, target, source_samples, target_samples, pool);
    exchangeParts(source, target, answerGap(target_samples), bent);
    return bent;
  });
}

std::optional<std::vector<Finalist>> findFinalists(const PosedSide& source_side,
                                                   const PosedSide& target_side,
                                                   const SpectralSurface& source,
                                                   const SpectralSurface& target,
                                                   std::vector<Finalist> finalists,
                                                   bool may_lack,
                                                   const RegistrationResult* known,
                                                   bool may_stop,
                                                   StageClock& clock) {
  const SampledShape &source_samples = source_side.shape.samples,
                     &target_samples = target_side.shape.samples;
  const double gap = answerGap(target_samples);
  const auto convince = [&] {
    return !finalists.empty() && convinces(finalists.front().score.total());
  };

  const auto distinct = [&] { return distinctFinalists(finalists, target.mesh, gap); };
  bool confirm_known = false;  // the best leads everywhere to where a trusted answer does
  bool known_stands = false;   // so that nothing more need be sought
  const auto lookAgain = [&] {
    confirm_known = confirms(known, source_side, target_side, finalists);
    known_stands =
        may_stop && confirm_known && knownStands(*known, finalists.front().score.total());
  };
  lookAgain();
  if (known_stands) return std::nullopt;
  // Where bodies stretch, the right candidate is not among those that change distances least, nor
  // where they lack parts.
  if (!convince() || (may_lack && !confirm_known && !isAllButCertain(finalists, distinct()))) {
    clock.stage("tips", 0.03, [&] {
      finalists = withTips(source_side, target_side, source, target, gap, std::move(finalists));
    });
    lookAgain();
    if (known_stands) return std::nullopt;
  }

  // A part that the other side lacks is squeezed onto what there is, and leads what is next to it
  // astray.
  if (may_lack && !confirm_known) {
    clock.stage("letting go", 0.03, [&] {
      const std::vector<int> different = distinct();
      finalists = withPartsLetGo(source, target, different, std::move(finalists));
    });
    // With holes closed the map is wanted for what it does not lose.
    const bool as_given =
        source_side.given.patch_vertices == 0 && target_side.given.patch_vertices == 0;
    lookAgain();
    if (known_stands) return std::nullopt;
    if (as_given && !confirm_known) {
      clock.stage("growing anew", 0.03, [&] {
        const std::vector<int> different = distinct();
        finalists = withPartsGrownAnew(source, target, different, gap, std::move(finalists));
      });
      clock.stage("turning", 0.03, [&] {
        const std::vector<int> different = distinct();
        finalists = withTurned(source,
                               target,
                               turnsOntoItself(source, source_samples),
                               turnsOntoItself(target, target_samples),
                               different,
                               gap,
                               std::move(finalists));
      });
    }
  }

  // Spectra and scale go astray where much is missing; surfaces laid over each other do not.
  if (!convince())
    clock.stage("laying over", 0.03, [&] {
      finalists = joined(
          std::move(finalists),
          layFinalists(source, target, source_side.coarsePlaces(), target_side.coarsePlaces()));
    });
  return finalists;
}

}  // namespace posture
