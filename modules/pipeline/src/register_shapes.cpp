// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/pipeline/register_shapes.h>
#include <posture/refine/map_score.h>

#include "contacts.h"
#include "prepare.h"
#include "published_method.h"
#include "refined_method.h"
#include "scan_side.h"
#include "stage_clock.h"
#include <stdexcept>
#include <utility>

namespace posture {
namespace {

RegistrationResult registerMeshes(const TriangleMesh& source,
                                  const TriangleMesh& target,
                                  const RegistrationOptions& options,
                                  StageClock& clock) {
  const auto [source_clean, target_clean] = clock.stage("cleaning", 0.02, [&] {
    return std::pair(cleanSide("source", source), cleanSide("target", target));
  });
  clock.show([&, &a = source_clean, &b = target_clean] { return cleaningPictures(a, b); });
  if (options.method == Method::PAPER)
    return publishedMethod({source, source_clean}, {target, target_clean}, clock);

  // Where a surface may be grown together with itself it is parted too: the better map tells.
  const auto [source_parted, target_parted] = clock.stage("contacts", 0, [&] {
    return std::pair(partedSurface(source, source_clean), partedSurface(target, target_clean));
  });
  const bool parted = source_parted.contacts > 0 || target_parted.contacts > 0;
  RegistrationResult result = clock.attempt("", parted ? 0.5 : 1, [&] {
    return refinedMethod({source, source_clean}, {target, target_clean}, options, clock);
  });
  if (!parted) return result;
  try {
    RegistrationResult other =
        clock.attempt("parted", 0.5, [&, &a = source_parted.clean, &b = target_parted.clean] {
          return refinedMethod({source, a}, {target, b}, options, clock);
        });
    other.source.parted_contacts = source_parted.contacts;
    other.target.parted_contacts = target_parted.contacts;
    if (other.score <= result.score - SCORE_NOISE) return other;
  } catch (const std::runtime_error&) {  // too little is left to work on
    if (clock.isStopped()) throw;
  }
  return result;
}

}  // namespace

RegistrationResult registerShapes(const TriangleMesh& source,
                                  const TriangleMesh& target,
                                  const RegistrationOptions& options,
                                  const Observer& observer) {
  StageClock clock(observer);
  RegistrationResult result = registerMeshes(source, target, options, clock);
  result.timings = clock.timings();
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
  RegistrationResult result =
      registerMeshes(source_surface.mesh, target_surface.mesh, options, clock);
  clock.stage("points", 0.01, [&] {
    referToPoints(source, target, std::move(source_surface), std::move(target_surface), result);
    return 0;
  });
  result.timings = clock.timings();
  return result;
}

}  // namespace posture
