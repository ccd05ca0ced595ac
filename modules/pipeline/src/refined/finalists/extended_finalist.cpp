// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "refined/finalists/extended_finalist.h"

#include <posture/refine/extend_map.h>
#include <posture/refine/settle.h>

#include "no_way_on.h"
#include "refined/work/coarse_map.h"
#include <cmath>
#include <utility>

namespace posture {

Finalist extendedFinalist(const CoarseSides& sides, const RegistrationResult& known) {
  const SpectralSurface &source = sides.source, &target = sides.target;
  ScoredPair extended = extendMap(source,
                                  target,
                                  settlingSoftness(source, target),
                                  coarseMapOf(sides.source_side, sides.target_side, known));
  Finalist finalist;
  finalist.maps = extended.pair.maps;
  finalist.orientation = orientation(source, target, finalist.maps);
  finalist.score = extended.score;
  if (finalist.orientation <= LEAST_ORIENTATION || !std::isfinite(finalist.score.total()))
    throw NoWayOn("the answer does not go on");
  finalist.bent = std::move(extended.pair);
  return finalist;
}

}  // namespace posture
