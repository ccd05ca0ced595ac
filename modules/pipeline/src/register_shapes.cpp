// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/pipeline/register_shapes.h>

#include "prepare.h"
#include "published_method.h"
#include "refined_method.h"
#include "scan_side.h"
#include "stage_clock.h"

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
  return options.method == Method::PAPER
             ? publishedMethod({source, source_clean}, {target, target_clean}, clock)
             : refinedMethod({source, source_clean}, {target, target_clean}, options, clock);
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
