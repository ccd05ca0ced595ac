// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/mesh/corners.h>
#include <posture/pipeline/register_shapes.h>

#include "answer/attempt.h"
#include "answer/message.h"
#include "answer/same_answer.h"
#include "answer/shared_verdict.h"
#include "answer/verdict.h"
#include "attempts/best_attempt.h"
#include "attempts/piece_attempts.h"
#include "attempts/register_joined.h"
#include "attempts/register_whole.h"
#include "outcome/drop_background.h"
#include "outcome/left_out_parts.h"
#include "outcome/refer_to_points.h"
#include "published/published_method.h"
#include "sides/clean_sides.h"
#include "sides/given_shape.h"
#include "sides/parts_like.h"
#include "sides/side_surface.h"
#include "stage_clock.h"
#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace posture {
namespace {

/// Less of the source with a counterpart may be for pieces that found no place; joining them has to
/// give so much more.
constexpr double NEARLY_ALL = 0.9, CLEARLY_MORE = 0.05;

/// The share of the source's surface that has a counterpart, by vertices: those of a background are
/// in no face.
double mappedOfSurface(const GivenShape& source, const RegistrationResult& result) {
  const std::vector<SurfacePoint>& on_target = result.correspondence.on_target;
  const std::vector<char> is_corner =
      cornersOfFaces(source.input.faces, static_cast<int>(on_target.size()));
  double all = 0, mapped = 0;
  for (std::size_t v = 0; v < on_target.size(); ++v) {
    if (is_corner[v] == 0) continue;
    ++all;
    mapped += on_target[v].vertex >= 0;
  }
  return all > 0 ? mapped / all : 0;
}

RegistrationResult registerMeshes(const GivenShape& source,
                                  const GivenShape& target,
                                  const RegistrationOptions& options,
                                  StageClock& clock) {
  if (options.method == Method::PAPER) return publishedMethod(source, target, clock);

  RegistrationResult main = registerWhole(source, target, options, clock);
  const double mapped = mappedOfSurface(source, main);
  std::optional<RegistrationResult> joined;
  if (!looksAlike(main) || mapped < NEARLY_ALL || isInPieces(source.clean) ||
      isInPieces(target.clean))
    joined = registerJoined(source, target, options, clock);
  const bool is_same = joined && isSameAnswer(main, *joined, target.input);
  if (is_same) payForHands(handsByBoth(*joined, main, target.input), *joined);
  if (is_same && joined->status == Status::REGISTERED && joined->hands <= main.hands &&
      !leadsAstray(main, *joined) && mappedOfSurface(source, *joined) > mapped + CLEARLY_MORE)
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
  auto surfaces = clock.stage("surfaces", 0.05, [&] {
    return std::pair(surfaceOf("source", source, options.surface),
                     surfaceOf("target", target, options.surface));
  });
  SideSurface &source_surface = surfaces.first, &target_surface = surfaces.second;
  RegistrationResult result = registerSurfaces(source_surface, target_surface, options, clock);
  clock.stage("points", 0.01, [&] {
    referToPoints(source, target, std::move(source_surface), std::move(target_surface), result);
  });
  conclude(clock, result);
  return result;
}

}  // namespace posture
