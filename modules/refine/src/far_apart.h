// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/types.h>
#include <posture/geodesic/distance_rows.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace posture {

/// Numbers in `among` of so many vertices that are far from each other along the surface: `first`,
/// then each the farthest from those before it. \pre  not empty.
inline std::vector<int> farApart(const DistanceRows& distances,
                                 const std::vector<int>& among,
                                 int first,
                                 std::size_t count) {
  std::vector<int> chosen;
  Vector nearest = Vector::Constant(static_cast<Eigen::Index>(among.size()),
                                    std::numeric_limits<double>::infinity());
  for (int next = first; chosen.size() < count; nearest.maxCoeff(&next)) {
    chosen.push_back(next);
    const std::vector<double>& from_it = distances.from(among[next]);
    for (std::size_t i = 0; i < among.size(); ++i)
      nearest[i] = std::min(nearest[i], from_it[among[i]]);
  }
  return chosen;
}

}  // namespace posture
