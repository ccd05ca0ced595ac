// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/pipeline/register_shapes.h>

#include "refined/finalists/finalists.h"
#include "refined/refinement/refined_maps.h"
#include "refined/work/posed_side.h"
#include "sides/given_shape.h"
#include <vector>

namespace posture {

/// What an attempt has found when its map is chosen, and what finishing it takes.
struct ChosenMap {
  ChosenMap(const GivenShape& source_cleaned, const GivenShape& target_cleaned)
      : source(source_cleaned), target(target_cleaned) {}

  PosedSide source, target;
  bool may_lack = false;
  std::vector<Finalist> finalists;
  RefinedMap best;
  RegistrationResult result;    ///< without a map, unless there is no finalist
  std::vector<int> begun_from;  ///< the finalist that each alternative is refined from
};

}  // namespace posture
