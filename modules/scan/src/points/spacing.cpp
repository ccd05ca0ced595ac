// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "points/spacing.h"

#include <posture/core/median.h>
#include <posture/core/parallel.h>

#include <algorithm>
#include <cmath>

namespace posture {

Spacing spacing(const Points& points, const NeighborTable& neighbors) {
  const int n = static_cast<int>(points.rows());
  std::vector<double> sides(n);
  forEach(n, [&](int i) {
    const int count = std::min(16, neighborCount(neighbors, i));
    if (count == 0) return;
    const double radius = (points.row(neighbors(i, count - 1)) - points.row(i)).norm();
    sides[i] = radius * std::sqrt(M_PI / count);
  });
  Spacing result{std::vector<double>(n), lowerMedian(sides)};
  forEach(n, [&](int i) {
    std::vector<double> around{sides[i]};
    for (int k = 0; k < std::min(16, neighborCount(neighbors, i)); ++k)
      around.push_back(sides[neighbors(i, k)]);
    result.at[i] = lowerMedian(std::move(around));
  });
  return result;
}

}  // namespace posture
