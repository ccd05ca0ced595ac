// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/types.h>

#include <vector>

namespace posture {

/// Rows of two sets of oriented points that are next to each other.
struct ClosestPair {
  int a, b;
  double squared;  ///< distance, that of the normals included
};

/// For each point of a the nearest of b, then for each of b the nearest of a.
/// \param normal_length  what normals are multiplied by before distances are taken.
std::vector<ClosestPair> closestPairs(const Points& places_a,
                                      const Points& normals_a,
                                      const Points& places_b,
                                      const Points& normals_b,
                                      double normal_length);

}  // namespace posture
