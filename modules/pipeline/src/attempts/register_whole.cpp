// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "attempts/register_whole.h"

#include <posture/core/parallel.h>

#include "answer/attempt.h"
#include "answer/same_answer.h"
#include "answer/shared_verdict.h"
#include "attempts/best_attempt.h"
#include "attempts/whole_attempts.h"
#include "sides/contacts.h"
#include "sides/patched_shape.h"
#include <algorithm>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace posture {
namespace {

/// What is taken of the attempts with holes as they are and closed, whether they have one answer or
/// two.
RegistrationResult bestOfBoth(Attempt as_given,
                              Attempt closed,
                              const TriangleMesh& target,
                              const RegistrationOptions& options,
                              StageClock& clock) {
  if (as_given.found.chosen < 0 || closed.found.chosen < 0 ||
      !isSameAnswer(as_given.found, closed.found, target)) {
    std::vector<Attempt> attempts;
    attempts.push_back(std::move(as_given));
    attempts.push_back(std::move(closed));
    return bestAttempt(
        std::move(attempts), target, options, [](const auto&) { return std::nullopt; }, clock);
  }
  const bool astray = leadsAstray(as_given.found, closed.found);
  Attempt &better = astray ? as_given : closed, &other = astray ? closed : as_given;
  const double of_better = handsByBoth(better.found, other.found, target),
               of_other = handsByBoth(other.found, better.found, target);
  std::optional<RegistrationResult> map = clock.tryTo([&] { return finished(std::move(better)); });
  if (!map) return finished(std::move(other));
  if (options.refine_alternatives)
    if (auto whole = clock.tryTo([&] { return finished(other); })) other.found = *whole;
  payForHands(of_other, other.found);
  payForHands(of_better, *map);
  return withMapOf(std::move(other.found), std::move(*map));
}

/// \param source_surface, target_surface  as withPatches() takes them.
template <class Surface>
PatchedSides patchedSides(const TriangleMesh& source,
                          const Surface& source_surface,
                          const TriangleMesh& target,
                          const Surface& target_surface) {
  PatchedSides patched;
  inParallel([&] { patched.source = withPatches(source, source_surface); },
             [&] { patched.target = withPatches(target, target_surface); });
  return patched;
}

}  // namespace

RegistrationResult registerWhole(const GivenShape& source,
                                 const GivenShape& target,
                                 const RegistrationOptions& options,
                                 StageClock& clock) {
  constexpr double MANY_RIMS = 0.5;
  const PartedSides parted = clock.stage("contacts", 0, [&] {
    return PartedSides{partedSurface(source.input, source.clean),
                       partedSurface(target.input, target.clean)};
  });
  const PatchedSides cut = clock.stage("holes", 0.01, [&] {
    return patchedSides(source.input, parted.source, target.input, parted.target);
  });
  const bool many = std::max(cut.source.rim_length, cut.target.rim_length) > MANY_RIMS;
  std::optional<PatchedSides> uncut;
  using MakeSides = std::function<const PatchedSides&()>;
  const auto makeUncut = [&]() -> const PatchedSides& {
    return uncut.emplace(patchedSides(source.input, source.clean, target.input, target.clean));
  };
  std::optional<Attempt> closed;
  if (many)
    closed = clock.tryAttempt("patched", 0.5, [&] {
      return patchedAttempt(
          source, target, cut, parted.any() ? MakeSides(makeUncut) : nullptr, options, clock);
    });
  const auto asGiven = [&](double portion, const RegistrationResult* known) {
    return clock.within(
        {"", portion}, [&] { return wholeAttempt(source, target, parted, options, known, clock); });
  };
  if (!closed) return finished(*asGiven(many ? 0.5 : 1, nullptr));
  const auto as_given = clock.tryTo([&] { return asGiven(0.5, &closed->found); });
  if (as_given && *as_given)
    return bestOfBoth(**as_given, std::move(*closed), target.input, options, clock);
  std::optional<RegistrationResult> known =
      clock.tryTo([&] { return finished(std::move(*closed)); });
  return known ? std::move(*known) : finished(*asGiven(0, nullptr));
}

}  // namespace posture
