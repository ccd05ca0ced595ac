// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/refine/bent_pair.h>

#include <vector>

namespace posture {

/// How often rotations and places alternate in one bending: the map that the goals come from is
/// renewed long before they would converge.
constexpr int BENDING_STEPS = 5;

/// How far the match of each vertex is to be believed: a match at the rim of a hole may stand for
/// any place inside it. \param apart  vertices whose match does not count, as in BentPair.
inline Vector belief(const BendableSurface& from,
                     const BendableSurface& to,
                     const std::vector<int>& matches,
                     const std::vector<char>& apart = {}) {
  Vector c = Vector::Ones(matches.size());
  for (std::size_t v = 0; v < matches.size(); ++v)
    if ((to.on_boundary[matches[v]] && !from.on_boundary[v]) || isApart(apart, v)) c[v] = 0;
  return c;
}

}  // namespace posture
