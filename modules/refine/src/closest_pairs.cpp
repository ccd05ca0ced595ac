// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "closest_pairs.h"

#include "nearest_rows.h"

namespace posture {

std::vector<ClosestPair> closestPairs(const Points& places_a,
                                      const Points& normals_a,
                                      const Points& places_b,
                                      const Points& normals_b,
                                      double normal_length) {
  Eigen::MatrixXf fa(places_a.rows(), 6), fb(places_b.rows(), 6);
  fa << places_a.cast<float>(), (normal_length * normals_a).cast<float>();
  fb << places_b.cast<float>(), (normal_length * normals_b).cast<float>();
  std::vector<int> forward, backward;
  nearestBothWays(fa, fb, forward, backward);
  std::vector<ClosestPair> pairs;
  const auto add = [&](int i, int j) {
    pairs.push_back({i, j, static_cast<double>((fa.row(i) - fb.row(j)).squaredNorm())});
  };
  for (std::size_t i = 0; i < forward.size(); ++i) add(static_cast<int>(i), forward[i]);
  for (std::size_t j = 0; j < backward.size(); ++j) add(backward[j], static_cast<int>(j));
  return pairs;
}

}  // namespace posture
