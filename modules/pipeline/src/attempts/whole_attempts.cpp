// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "attempts/whole_attempts.h"

#include <posture/deformation/arap.h>
#include <posture/refine/map_score.h>

#include "answer/shared_verdict.h"
#include "answer/verdict.h"
#include "attempts/leave_out_patches.h"
#include "refined/refined_method.h"
#include <functional>
#include <string>
#include <utility>

namespace posture {
namespace {

/// Hands cost where a side may lack parts, so mostly on the surface cut open alone: the two are
/// compared without.
double scoreApartFromHands(const Attempt& attempt) {
  return attempt.found.score - attempt.found.hands;
}

GivenShape cutOpen(const GivenShape& shape, const PartedSurface& parted) {
  return {shape.input, parted.clean, shape.patch_vertices, shape.is_patched};
}

/// Makes a result found on surfaces cut open one of the whole: summaries of all of it, and how many
/// contacts were cut.
std::function<void(RegistrationResult&)> ofParted(const GivenShape& source,
                                                  const GivenShape& target,
                                                  const PartedSides& parted) {
  return [of_source = summarize(source),
          of_target = summarize(target),
          a = parted.source.contacts,
          b = parted.target.contacts](RegistrationResult& result) {
    result.source = withMeasured(of_source, result.source);
    result.target = withMeasured(of_target, result.target);
    result.source.parted_contacts = a;
    result.target.parted_contacts = b;
  };
}

/// The attempt with what `change` makes of its results.
BegunAttempt withChange(BegunAttempt begun,
                        const std::function<void(RegistrationResult&)>& change) {
  begun.goOn = [go_on = std::move(begun.goOn), change](const KnownAnswer& known) {
    std::optional<Attempt> attempt = go_on(known);
    return attempt ? std::optional(withChange(std::move(*attempt), change)) : std::nullopt;
  };
  return begun;
}

}  // namespace

Attempt betterOf(const BegunAttempt& whole,
                 const BegunAttempt& cut,
                 const RegistrationResult* known,
                 StageClock& clock) {
  std::optional<Attempt> as_given, other;
  bool is_whole_left = true;  // not gone on with
  const auto isConvincing = [](const std::optional<Attempt>& attempt) {
    return attempt && looksAlike(attempt->found);
  };
  const auto goOnAsGiven = [&] {
    is_whole_left = false;
    as_given = clock.tryTo([&] { return *whole.goOn({known}); });
  };
  const bool as_given_first = isDecisive(whole.score, cut.score);
  if (as_given_first) goOnAsGiven();
  if (!isConvincing(as_given)) other = clock.tryTo([&] { return *cut.goOn({known}); });
  if (other && other->found.chosen < 0) other.reset();  // it has no map
  if (!as_given_first && !(isConvincing(other) && isDecisive(cut.score, whole.score)))
    goOnAsGiven();
  if (!as_given && !other) throw TornSurface("neither surface can be bent onto the other");
  if (as_given &&
      (!other || (as_given->found.chosen >= 0 &&
                  scoreApartFromHands(*other) > scoreApartFromHands(*as_given) - SCORE_NOISE)))
    return std::move(*as_given);
  Attempt taken = std::move(*other);
  taken.finish = [finish = std::move(taken.finish),
                  whole,
                  is_whole_left,
                  as_given = std::move(as_given),
                  &clock] {
    if (!as_given && !is_whole_left) return finish();
    std::optional<RegistrationResult> result = clock.tryTo(finish);
    return result ? std::move(*result) : finished(as_given ? *as_given : *whole.goOn({}));
  };
  return taken;
}

std::optional<Attempt> wholeAttempt(const GivenShape& source,
                                    const GivenShape& target,
                                    const PartedSides& parted,
                                    const RegistrationOptions& options,
                                    const RegistrationResult* known,
                                    StageClock& clock) {
  const bool any = parted.any();
  const double portion = clock.label().portion;
  const auto begin = [&] {
    return clock.within({"", any ? portion / 2 : portion},
                        [&] { return beginAttempt(source, target, options, clock); });
  };
  if (!any) return begin().goOn({known, true});
  const std::optional<BegunAttempt> whole = clock.tryTo(begin);
  const std::optional<BegunAttempt> cut = clock.tryAttempt("parted", portion / 2, [&] {
    return withChange(
        beginAttempt(
            cutOpen(source, parted.source), cutOpen(target, parted.target), options, clock),
        ofParted(source, target, parted));
  });
  if (!whole && !cut) throw TornSurface("neither surface can be bent onto the other");
  if (!whole || !cut) return (whole ? whole : cut)->goOn({known});
  return betterOf(*whole, *cut, known, clock);
}

Attempt patchedAttempt(const GivenShape& source,
                       const GivenShape& target,
                       const PatchedSides& cut,
                       const std::function<const PatchedSides&()>& uncut,
                       const RegistrationOptions& options,
                       StageClock& clock) {
  const auto attempt = [&](const PatchedSides& sides) {
    return withChange(refinedMethod(sides.source.given(), sides.target.given(), options, clock),
                      [&source, &target, &sides](RegistrationResult& result) {
                        leaveOutPatches(source, sides.source, target, sides.target, result);
                      });
  };
  std::optional<Attempt> as_cut = clock.tryTo([&] { return attempt(cut); }), other;
  if (uncut && !(as_cut && looksAlike(as_cut->found))) {
    // Where the cut alone made the holes these are the surfaces as they are.
    const auto closed = clock.tryTo([&] { return &uncut(); });
    if (closed && (*closed)->source.patched_holes + (*closed)->target.patched_holes > 0)
      other = clock.tryAttempt("patched-uncut", 0, [&] { return attempt(**closed); });
  }
  if (!as_cut && !other) throw TornSurface("no surface can be bent with its holes closed");
  const bool is_better = other && other->found.chosen >= 0 &&
                         (!as_cut || as_cut->found.chosen < 0 ||
                          scoreApartFromHands(*other) < scoreApartFromHands(*as_cut) - SCORE_NOISE);
  return std::move(is_better || !as_cut ? *other : *as_cut);
}

}  // namespace posture
