// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "refined/refined_method.h"

#include <posture/core/error.h>

#include "answer/verdict.h"
#include "refined/choose_map.h"
#include "refined/finalists/extended_finalist.h"
#include "refined/finish_map.h"
#include "refined/first_maps.h"
#include "refined/refinement/refined_result.h"
#include "refined/work/coarse_map.h"
#include <memory>
#include <utility>

namespace posture {
namespace {

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
  begun.goOn = [first, options, &clock, label = clock.label()](const KnownAnswer& known) {
    require(first->chosen != nullptr, "BegunAttempt: gone on with twice");
    const FirstMaps maps = std::move(*first);
    return clock.within(label, [&]() -> std::optional<Attempt> {
      if (!chooseMap(maps, known, clock)) return {};
      return attemptAt(maps.chosen, options, clock);
    });
  };
  return begun;
}

Attempt refinedMethod(const GivenShape& source,
                      const GivenShape& target,
                      const RegistrationOptions& options,
                      StageClock& clock) {
  return *beginAttempt(source, target, options, clock).goOn({});
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
