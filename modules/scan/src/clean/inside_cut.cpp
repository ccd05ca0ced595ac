// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "clean/inside_cut.h"

#include <posture/mesh/minimum_cut.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace posture {
namespace {

/// How a tetrahedron is seen from one of its corners.
struct Aspect {
  Eigen::RowVector3d direction;  ///< unit vector into it
  double share;                  ///< of the sphere of directions
};

Aspect aspect(const Points& points, const std::array<int, 4>& corners, int from) {
  std::array<Eigen::RowVector3d, 3> edges;
  int count = 0;
  for (int v : corners)
    if (v != from) edges[count++] = (points.row(v) - points.row(from)).normalized();
  // Van Oosterom and Strackee (1983).
  const double solid_angle =
      2 * std::atan2(std::abs(edges[0].dot(edges[1].cross(edges[2]))),
                     1 + edges[0].dot(edges[1]) + edges[1].dot(edges[2]) + edges[2].dot(edges[0]));
  return {(edges[0] + edges[1] + edges[2]).normalized(), solid_angle / (4 * M_PI)};
}

/// What the points say of each tetrahedron: positive for outside. A point has one vote for the
/// sphere that reaches farthest along its normal, one against the one farthest behind it, and
/// four that it spreads over all directions.
std::vector<double> votes(const Points& points,
                          const Stars& stars,
                          const Circumspheres& spheres,
                          const Points& normals) {
  constexpr double ALL_ROUND = 4;
  // Of an infinite tetrahedron; there are few at a point.
  constexpr double SHARE_OF_INFINITE = 0.1;
  const Tetrahedra& tetrahedra = spheres.tetrahedra();
  std::vector<double> outside(tetrahedra.size(), 0);
  for (int i = 0; i < points.rows(); ++i) {
    const Eigen::RowVector3d normal = normals.row(i);
    int before = -1, behind = -1;
    double farthest_before = 0, farthest_behind = 0;
    for (int s = stars.first[i]; s < stars.first[i + 1]; ++s) {
      const int t = stars.tetrahedra[s];
      double along = spheres.direction(i, t).dot(normal);
      if (spheres.isInfinite(t)) {
        outside[t] += ALL_ROUND * SHARE_OF_INFINITE * along;
        along *= 1e9;
      } else {
        const Aspect seen = aspect(points, tetrahedra.corners[t], i);
        outside[t] += ALL_ROUND * seen.share * seen.direction.dot(normal);
      }
      if (along > farthest_before) farthest_before = along, before = t;
      if (along < farthest_behind) farthest_behind = along, behind = t;
    }
    if (before >= 0) outside[before] += 1;
    if (behind >= 0) outside[behind] -= 1;
  }
  return outside;
}

/// Of a face between inside and outside: 0.05 to 1.05.
double faceCost(const Circumspheres& spheres, int t, int k) {
  const Tetrahedra& tetrahedra = spheres.tetrahedra();
  // Of two surfaces equally good the one of fewer faces.
  constexpr double EACH = 0.05;
  const double worse =
      std::min(spheres.faceCosine(t, k),
               spheres.faceCosine(tetrahedra.beyond[t][k], tetrahedra.mirror(t, k)));
  return (1 - worse) / 2 + EACH;
}

}  // namespace

std::vector<char> insideByCut(const Points& points,
                              const Stars& stars,
                              const Circumspheres& spheres,
                              const Points& normals) {
  const Tetrahedra& tetrahedra = spheres.tetrahedra();
  const std::vector<double> outside = votes(points, stars, spheres, normals);
  MinimumCut cut(tetrahedra.size());
  for (int t = 0; t < tetrahedra.size(); ++t) {
    if (outside[t] > 0) cut.joinSource(t, outside[t]);
    if (outside[t] < 0) cut.joinSink(t, -outside[t]);
    for (int k = 0; k < 4; ++k) {
      const int beyond = tetrahedra.beyond[t][k];
      if (beyond < t) continue;
      const double cost = faceCost(spheres, t, k);
      cut.join(t, beyond, cost);
    }
  }
  return cut.onSinkSide();
}

}  // namespace posture
