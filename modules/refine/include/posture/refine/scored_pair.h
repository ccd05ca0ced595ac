// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/refine/bent_pair.h>
#include <posture/refine/map_score.h>

namespace posture {

/// Two surfaces bent onto each other, with what speaks against the map.
struct ScoredPair {
  BentPair pair;
  MapScore score;
};

}  // namespace posture
