// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "noisy/thinning.h"

#include <posture/core/rng.h>

#include <numeric>
#include <utility>
#include <vector>

namespace posture {

OrientedPoints thin(const OrientedPoints& oriented,
                    const NeighborTable& neighbors,
                    const Spacing& spacing) {
  constexpr double CLOSE = 0.5;  // in spacings
  const int n = static_cast<int>(oriented.points.rows());
  std::vector<int> order(n);
  std::iota(order.begin(), order.end(), 0);
  Rng rng(1);
  for (int i = n - 1; i > 0; --i) std::swap(order[i], order[rng.below(i + 1)]);

  // Neighbours are asked and told: a table may name only one of two points to the other.
  std::vector<char> taken(n, 0), covered(n, 0);
  for (int i : order) {
    if (covered[i]) continue;
    const auto close = [&](int j) {
      return (oriented.points.row(j) - oriented.points.row(i)).norm() < CLOSE * spacing.at[i] &&
             sameSheet(oriented.normals.row(i), oriented.normals.row(j));
    };
    bool free = true;
    for (int j : neighbors.row(i)) free = free && (j < 0 || !taken[j] || !close(j));
    if (!free) continue;
    taken[i] = 1;
    for (int j : neighbors.row(i))
      if (j >= 0 && close(j)) covered[j] = 1;
  }
  std::vector<int> kept;
  for (int i = 0; i < n; ++i)
    if (taken[i]) kept.push_back(i);
  return {oriented.points(kept, Eigen::all), oriented.normals(kept, Eigen::all)};
}

}  // namespace posture
