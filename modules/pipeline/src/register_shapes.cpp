// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/pipeline/register_shapes.h>

#include "prepare.h"
#include "published_method.h"
#include "refined_method.h"
#include "stage_clock.h"

namespace posture {

RegistrationResult registerShapes(const TriangleMesh& source,
                                  const TriangleMesh& target,
                                  const RegistrationOptions& options,
                                  const Observer& observer) {
  StageClock clock(observer);
  const auto [source_clean, target_clean] = clock.stage("cleaning", 0.02, [&] {
    return std::pair(cleanSide("source", source), cleanSide("target", target));
  });
  clock.show([&, &a = source_clean, &b = target_clean] { return cleaningPictures(a, b); });
  RegistrationResult result =
      options.method == Method::PAPER
          ? publishedMethod({source, source_clean}, {target, target_clean}, clock)
          : refinedMethod({source, source_clean}, {target, target_clean}, options, clock);
  result.timings = clock.timings();
  return result;
}

}  // namespace posture
