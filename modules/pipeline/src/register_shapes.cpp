// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/parallel.h>
#include <posture/pipeline/register_shapes.h>

#include "answer/attempt.h"
#include "answer/message.h"
#include "answer/same_answer.h"
#include "answer/shared_verdict.h"
#include "answer/verdict.h"
#include "attempts/best_attempt.h"
#include "attempts/leave_out_patches.h"
#include "attempts/piece_attempts.h"
#include "attempts/whole_attempts.h"
#include "outcome/drop_background.h"
#include "outcome/left_out_parts.h"
#include "outcome/refer_to_points.h"
#include "published/published_method.h"
#include "refined/refined_method.h"
#include "sides/clean_sides.h"
#include "sides/contacts.h"
#include "sides/given_shape.h"
#include "sides/parts_like.h"
#include "sides/patched_shape.h"
#include "sides/side_surface.h"
#include "stage_clock.h"
#include <algorithm>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace posture {
namespace {

/// Less of the source with a counterpart may be for pieces that found no place; joining them has to
/// give so much more.
constexpr double NEARLY_ALL = 0.9, CLEARLY_MORE = 0.05;

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
  parallelFor(2, [&](int side) {
    if (side == 0)
      patched.source = withPatches(source, source_surface);
    else
      patched.target = withPatches(target, target_surface);
  });
  return patched;
}

/// Registers the shapes as they are and, where there are holes to speak of, first with those closed
/// that may be.
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
  const bool many = std::max(cut.source.rims, cut.target.rims) > MANY_RIMS;
  std::optional<PatchedSides> uncut;
  std::function<const PatchedSides&()> makeUncut;
  if (parted.any())
    makeUncut = [&]() -> const PatchedSides& {
      return uncut.emplace(patchedSides(source.input, source.clean, target.input, target.clean));
    };
  std::optional<Attempt> closed;
  if (many)
    closed = clock.tryAttempt("patched", 0.5, [&] {
      return patchedAttempt(source, target, cut, makeUncut, options, clock);
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

/// For surfaces in pieces: joined where the gaps between them are narrow, they may tell more.
std::optional<RegistrationResult> registerJoined(const GivenShape& source,
                                                 const GivenShape& target,
                                                 const RegistrationOptions& options,
                                                 StageClock& clock) {
  const auto [source_joined, target_joined] = clock.stage("joining", 0, [&] {
    return std::pair(withBridges(source.input, source.clean),
                     withBridges(target.input, target.clean));
  });
  if (source_joined.pieces == 0 && target_joined.pieces == 0) return {};
  std::optional<RegistrationResult> joined =
      clock.tryAttempt("joined", 0, [&, &a = source_joined, &b = target_joined] {
        return finished(refinedMethod(a.given(), b.given(), options, clock));
      });
  if (joined) leaveOutPatches(source, source_joined, target, target_joined, *joined);
  return joined;
}

RegistrationResult registerMeshes(const GivenShape& source,
                                  const GivenShape& target,
                                  const RegistrationOptions& options,
                                  StageClock& clock) {
  if (options.method == Method::PAPER) return publishedMethod(source, target, clock);

  RegistrationResult main = registerWhole(source, target, options, clock);
  const double mapped = mappedShare(main);
  std::optional<RegistrationResult> joined;
  if (!looksAlike(main) || mapped < NEARLY_ALL || isInPieces(source.clean) ||
      isInPieces(target.clean))
    joined = registerJoined(source, target, options, clock);
  const bool is_same = joined && isSameAnswer(main, *joined, target.input);
  if (is_same) payForHands(handsByBoth(*joined, main, target.input), *joined);
  if (is_same && joined->status == Status::REGISTERED && joined->hands <= main.hands &&
      !leadsAstray(main, *joined) && mappedShare(*joined) > mapped + CLEARLY_MORE)
    return std::move(*joined);
  std::vector<Attempt> attempts;
  attempts.push_back({std::move(main), {}});
  if (joined) attempts.push_back({std::move(*joined), {}});
  if (std::none_of(attempts.begin(), attempts.end(), [](const Attempt& attempt) {
        return attempt.found.trust >= ALL_BUT_CERTAIN;
      }))
    addPieceAttempts(source, target, options, clock, attempts);
  const auto extended = [&](const RegistrationResult& known) {
    return extendedToWhole(source, target, known, options, clock);
  };
  return bestAttempt(std::move(attempts), target.input, options, extended, clock);
}

/// What cleanSides() did to a side before its shape was measured.
void notePreparation(const SideSurface& side, ShapeSummary& summary, Points& denoised) {
  summary.denoising = side.denoising;
  summary.background_faces = side.background.faces;
  if (side.denoising.movedAny()) denoised = side.mesh.vertices;
}

RegistrationResult registerSurfaces(SideSurface& source,
                                    SideSurface& target,
                                    const RegistrationOptions& options,
                                    StageClock& clock) {
  const CleanSides clean =
      clock.stage("cleaning", 0.02, [&] { return cleanSides(source, target); });
  clock.show([&] { return cleaningPictures(clean.source, clean.target); });
  const GivenShape from{source.mesh, clean.source}, to{target.mesh, clean.target};
  RegistrationResult result = registerMeshes(from, to, options, clock);
  notePreparation(source, result.source, result.source_denoised);
  notePreparation(target, result.target, result.target_denoised);
  dropBackground(source.background, source.mesh.vertices, target.background, result);
  noteLeftOutParts(from, to, result);
  return result;
}

void conclude(const StageClock& clock, RegistrationResult& result) {
  result.message = messageOf(result);
  result.timings = clock.timings();
}

}  // namespace

RegistrationResult registerShapes(const TriangleMesh& source,
                                  const TriangleMesh& target,
                                  const RegistrationOptions& options,
                                  const Observer& observer) {
  StageClock clock(observer);
  SideSurface source_surface(source), target_surface(target);
  RegistrationResult result = registerSurfaces(source_surface, target_surface, options, clock);
  conclude(clock, result);
  return result;
}

RegistrationResult registerShapes(const Shape& source,
                                  const Shape& target,
                                  const RegistrationOptions& options,
                                  const Observer& observer) {
  StageClock clock(observer);
  auto [source_surface, target_surface] = clock.stage("surfaces", 0.05, [&] {
    return std::pair(surfaceOf("source", source, options.surface),
                     surfaceOf("target", target, options.surface));
  });
  RegistrationResult result = registerSurfaces(source_surface, target_surface, options, clock);
  clock.stage("points", 0.01, [&] {
    referToPoints(source, target, std::move(source_surface), std::move(target_surface), result);
  });
  conclude(clock, result);
  return result;
}

}  // namespace posture
