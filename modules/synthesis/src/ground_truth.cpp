// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/error.h>
#include <posture/synthesis/articulated_body.h>

#include <array>
#include <cmath>
#include <map>

namespace posture {
namespace {

/// Nearest of a set of points, where there is one within `reach`: looked up in boxes of that size.
class NearbyPoints {
 public:
  NearbyPoints(const Points& points, double reach) : points_(points), reach_(reach) {
    for (int i = 0; i < points.rows(); ++i) boxes_[boxOf(points.row(i))].push_back(i);
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

double meanEdge(const Faces& faces, const Points& places) {
  double sum = 0;
  for (int f = 0; f < faces.rows(); ++f)
    for (int i = 0; i < 3; ++i)
      sum += (places.row(faces(f, i)) - places.row(faces(f, (i + 1) % 3))).norm();
  return sum / static_cast<double>(std::max<Eigen::Index>(3 * faces.rows(), 1));
}

std::vector<VertexPair> nearestPairs(const Points& places,
                                     const ArticulatedBody& target,
                                     double slack) {
  require(
      target.rest_position.rows() == target.mesh.vertices.rows() && target.mesh.faces.rows() > 0,
      "ground truth: the target has no rest places or no faces");
  const double reach = meanEdge(target.mesh.faces, target.rest_position) + slack;
  const NearbyPoints nearby(target.rest_position, reach);
  std::vector<VertexPair> pairs;
  for (int i = 0; i < places.rows(); ++i) {
    const int found = nearby.nearest(places.row(i));
    if (found >= 0) pairs.push_back({i, found});
  }
  return pairs;
}

}  // namespace

std::vector<VertexPair> groundTruth(const ArticulatedBody& source, const ArticulatedBody& target) {
  return nearestPairs(source.rest_position, target, 0);
}

std::vector<VertexPair> mirrorTruth(const ArticulatedBody& source, const ArticulatedBody& target) {
  constexpr double ASYMMETRY = 0.012;  // the halves of the body differ by at most about so much
  Points reflected = source.rest_position;
  reflected.col(0) *= -1;
  return nearestPairs(reflected, target, ASYMMETRY);
}

}  // namespace posture
