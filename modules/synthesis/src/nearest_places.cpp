// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nearest_places.h"

#include <array>
#include <cmath>
#include <map>

namespace posture::synthesis {
namespace {

/// Nearest of a set of points, where there is one within `reach`: looked up in boxes of that size.
class NearbyPoints {
 public:
  NearbyPoints(const Points& points, double reach) : points_(points), reach_(reach) {
    for (int i = 0; i < points.rows(); ++i)
      if (points.row(i).allFinite()) boxes_[boxOf(points.row(i))].push_back(i);
  }

  int nearest(const Eigen::RowVector3d& place) const {
    const Box middle = boxOf(place);
    int best = -1;
    double best_sq = reach_ * reach_;
    for (int box = 0; box < 27; ++box) {
      const auto found = boxes_.find(
          {middle[0] + box % 3 - 1, middle[1] + box / 3 % 3 - 1, middle[2] + box / 9 - 1});
      if (found == boxes_.end()) continue;
      for (int i : found->second) {
        const double sq = (points_.row(i) - place).squaredNorm();
        if (sq < best_sq || (sq == best_sq && i < best)) best_sq = sq, best = i;
      }
    }
    return best;
  }

 private:
  using Box = std::array<int, 3>;
  Box boxOf(const Eigen::RowVector3d& p) const {
    return {static_cast<int>(std::floor(p.x() / reach_)),
            static_cast<int>(std::floor(p.y() / reach_)),
            static_cast<int>(std::floor(p.z() / reach_))};
  }

  const Points& points_;
  double reach_;
  std::map<Box, std::vector<int>> boxes_;
};

}  // namespace

std::vector<VertexPair> nearestPairs(const Points& places, const Points& targets, double reach) {
  const NearbyPoints nearby(targets, reach);
  std::vector<VertexPair> pairs;
  for (int i = 0; i < places.rows(); ++i) {
    if (!places.row(i).allFinite()) continue;
    const int found = nearby.nearest(places.row(i));
    if (found >= 0) pairs.push_back({i, found});
  }
  return pairs;
}

Points mirrored(Points places) {
  places.col(0) *= -1;
  return places;
}

}  // namespace posture::synthesis
