// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "noisy/tangent_delaunay.h"

#include <posture/core/parallel.h>
#include <posture/core/rng.h>

#include <Eigen/Geometry>

#include "noisy/thinning.h"
#include <algorithm>
#include <cmath>

namespace posture {
namespace {

struct FlatNeighbor {
  int index;
  Eigen::Vector2d inverted;  ///< q / |q|^2 of its place q in the tangent plane
};

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// Counter-clockwise (Andrew's monotone chain).
std::vector<FlatNeighbor> convexHull(std::vector<FlatNeighbor> points) {
  if (points.size() < 3) return points;
  std::sort(points.begin(), points.end(), [](const FlatNeighbor& a, const FlatNeighbor& b) {
    if (a.inverted.x() != b.inverted.x()) return a.inverted.x() < b.inverted.x();
    if (a.inverted.y() != b.inverted.y()) return a.inverted.y() < b.inverted.y();
    return a.index < b.index;
  });
  std::vector<FlatNeighbor> hull;
  const auto extend = [&](const FlatNeighbor& p, std::size_t least) {
    while (hull.size() >= least + 2 && cross(hull.back().inverted - hull[hull.size() - 2].inverted,
                                             p.inverted - hull.back().inverted) <= 0)
      hull.pop_back();
    hull.push_back(p);
  };
  for (const FlatNeighbor& p : points) extend(p, 0);
  const std::size_t lower = hull.size() - 1;
  for (std::size_t i = points.size(); i-- > 1;) extend(points[i - 1], lower);
  hull.pop_back();
  return hull;
}

class Stars {
 public:
  Stars(const OrientedPoints& oriented,
        const NeighborSearch& search,
        const NeighborTable& neighbors,
        const Spacing& spacing)
      : points_(oriented.points),
        normals_(oriented.normals),
        search_(search),
        neighbors_(neighbors),
        spacing_(spacing.at) {
    // Points of a depth image may lie on a lattice, whose Delaunay triangulation is not unique;
    // moved this little, all stars decide alike.
    constexpr double LITTLE = 1e-4;
    Rng rng(2);
    for (int i = 0; i < points_.size(); ++i)
      points_.data()[i] += LITTLE * spacing.at[i / 3] * (rng.uniform() - 0.5);
  }

  /// Triangles of the Delaunay star of point i in its tangent plane.
  void collect(int i, std::vector<std::array<int, 3>>& triangles) const {
    const double reach = reachOf(i);
    const std::vector<FlatNeighbor> star = convexHull(flatten(i, reach));
    if (star.size() < 2) return;
    for (std::size_t k = 0; k < star.size(); ++k) {
      const FlatNeighbor &a = star[k], &b = star[(k + 1) % star.size()];
      // An edge of the hull that is seen from outside: point i is on the border.
      if (!(cross(a.inverted, b.inverted) > 0)) continue;
      if ((points_.row(a.index) - points_.row(b.index)).norm() > reach) continue;
      std::array<int, 3> corners{i, a.index, b.index};
      std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
      triangles.push_back(corners);
    }
  }

 private:
  /// Longest edge at point i: four times the spacing there, as the eighth neighbour on the same
  /// sheet tells it.
  double reachOf(int i) const {
    constexpr int EIGHTH = 8;
    constexpr double SPARSEST = 2.5;  // in spacings over all sheets
    int same = 0;
    double radius = 0;
    for (int j : neighbors_.row(i)) {
      if (j < 0 || same == EIGHTH) break;
      if (!sameSheet(normals_.row(i), normals_.row(j))) continue;
      ++same;
      radius = (points_.row(j) - points_.row(i)).norm();
    }
    const double most = SPARSEST * spacing_[i];
    const double side = same < EIGHTH ? most : radius * std::sqrt(M_PI / EIGHTH);
    return SURFACE_REACH * std::clamp(side, spacing_[i], most);
  }

  std::vector<FlatNeighbor> flatten(int i, double reach) const {
    const Eigen::RowVector3d point = points_.row(i), normal = normals_.row(i);
    const Eigen::RowVector3d u = normal.unitOrthogonal(), v = normal.cross(u);
    // A neighbour that stands up from the plane is none; one farther than LONG spacings is on
    // another sheet where the normals turn away from each other by more.
    constexpr double STEEPEST = 0.8, LONG = 1.5, APART = 0.3;
    std::vector<FlatNeighbor> flat;
    const auto add = [&](int j) {
      const Eigen::RowVector3d offset = points_.row(j) - point;
      const double length = offset.norm(), height = offset.dot(normal);
      if (j == i || length > reach || length == 0 || std::abs(height) > STEEPEST * length) return;
      if (!sameSheet(normal, normals_.row(j))) return;
      if (length > LONG * std::max(spacing_[i], spacing_[j]) &&
          (normal - normals_.row(j)).dot(offset) > APART * length)
        return;
      // Laid flat with its length kept; inverted, its length is the inverse.
      const Eigen::Vector2d q(offset.dot(u), offset.dot(v));
      flat.push_back({j, q / (q.norm() * length)});
    };
    const int last = neighborCount(neighbors_, i) - 1;
    const bool table_suffices =
        last >= 0 && (points_.row(neighbors_(i, last)) - point).norm() > reach;
    if (table_suffices)
      for (int j : neighbors_.row(i)) add(j);
    else
      for (int j : search_.within(point, reach)) add(j);
    return flat;
  }

  Points points_;
  const Points& normals_;
  const NeighborSearch& search_;
  const NeighborTable& neighbors_;
  const std::vector<double>& spacing_;
};

}  // namespace

std::vector<TangentTriangle> tangentDelaunay(const OrientedPoints& oriented,
                                             const NeighborSearch& search,
                                             const NeighborTable& neighbors,
                                             const Spacing& spacing) {
  const int n = static_cast<int>(oriented.points.rows());
  const Stars stars(oriented, search, neighbors, spacing);
  constexpr int BLOCK = 1024;
  std::vector<std::vector<std::array<int, 3>>> of_block((n + BLOCK - 1) / BLOCK);
  forBlocks(n, BLOCK, [&](int first, int last) {
    for (int i = first; i < last; ++i) stars.collect(i, of_block[first / BLOCK]);
  });
  std::vector<std::array<int, 3>> seen;
  for (auto& triangles : of_block) {
    seen.insert(seen.end(), triangles.begin(), triangles.end());
    triangles = {};
  }
  std::sort(seen.begin(), seen.end());
  std::vector<TangentTriangle> candidates;
  for (std::size_t first = 0, last; first < seen.size(); first = last) {
    for (last = first + 1; last < seen.size() && seen[last] == seen[first];) ++last;
    if (last - first >= 2) candidates.push_back({seen[first], static_cast<int>(last - first)});
  }
  return candidates;
}

}  // namespace posture
