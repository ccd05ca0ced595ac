// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/refine/surface.h>

#include <vector>

namespace posture {

/// Vertices at most so many edges from some others, along edges between vertices that do not count
/// as seen; by increasing number of edges.
/// \param front  where it begins, not returned.
/// \param seen   n, non-zero for `front` and for what is not entered.
std::vector<int> ringsAround(const BendableSurface& surface,
                             std::vector<int> front,
                             std::vector<char> seen,
                             long rings);

}  // namespace posture
