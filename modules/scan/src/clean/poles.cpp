// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "clean/poles.h"

#include <posture/core/parallel.h>

#include "points/signed_sets.h"
#include <algorithm>
#include <numeric>
#include <tuple>

namespace posture {
namespace {

/// Tetrahedra of a point: the one with the farthest centre, and of those on the other side of the
/// point the one with the farthest; or -1.
struct Poles {
  int first = -1, second = -1;
};

Poles polesOf(int point, const Stars& stars, const Circumspheres& spheres) {
  Poles poles;
  Eigen::RowVector3d hull = Eigen::RowVector3d::Zero();
  for (int s = stars.first[point]; s < stars.first[point + 1]; ++s) {
    const int t = stars.tetrahedra[s];
    if (spheres.isInfinite(t)) hull += spheres.direction(point, t);
    if (poles.first < 0 || spheres.radius(t) > spheres.radius(poles.first)) poles.first = t;
  }
  if (poles.first < 0) return poles;
  const Eigen::RowVector3d towards =
      spheres.isInfinite(poles.first) ? hull : spheres.direction(point, poles.first);
  for (int s = stars.first[point]; s < stars.first[point + 1]; ++s) {
    const int t = stars.tetrahedra[s];
    if (spheres.direction(point, t).dot(towards) < 0 &&
        (poles.second < 0 || spheres.radius(t) > spheres.radius(poles.second)))
      poles.second = t;
  }
  return poles;
}

struct Link {
  double strength;
  int first, second;
  bool opposed;

  /// Strong ones first.
  bool operator<(const Link& other) const {
    return std::tie(other.strength, first, second, opposed) <
           std::tie(strength, other.first, other.second, other.opposed);
  }
};

/// Tetrahedra on one side and on the other; which is which is left open.
SignedSets divide(const Circumspheres& spheres, const std::vector<Poles>& poles) {
  const Tetrahedra& tetrahedra = spheres.tetrahedra();
  std::vector<Link> links;
  for (int t = 0; t < tetrahedra.size(); ++t)
    for (int beyond : tetrahedra.beyond[t])
      if (t < beyond) links.push_back({spheres.overlap(t, beyond), t, beyond, false});
  for (const Poles& p : poles)
    if (p.second >= 0)
      links.push_back({-spheres.overlap(p.first, p.second), p.first, p.second, true});
  std::sort(links.begin(), links.end());
  SignedSets sides(tetrahedra.size());
  for (const Link& l : links) sides.join(l.first, l.second, l.opposed);
  return sides;
}

}  // namespace

Points poleNormals(const Points& points,
                   const Stars& stars,
                   const Circumspheres& spheres,
                   const Spacing& spacing,
                   const OutsideHints& hints,
                   OrientationSummary& summary) {
  const int n = static_cast<int>(points.rows());
  std::vector<Poles> poles(n);
  forEach(n, [&](int i) { poles[i] = polesOf(i, stars, spheres); });
  SignedSets sides = divide(spheres, poles);
  Points normals = Points::Zero(n, 3);
  for (int i = 0; i < n; ++i)
    if (const int t = poles[i].first; t >= 0)
      normals.row(i) = (sides.isFlipped(t) ? -1 : 1) * spheres.direction(i, t).normalized();
  std::vector<int> all(n);
  std::iota(all.begin(), all.end(), 0);
  const bool has_sensor = hints.source == HintSource::SENSOR;
  const SensorView view = has_sensor
                              ? sensorView(hints, points, normals, spacing, std::vector<int>(n, 0))
                              : SensorView{};
  const OutsideHints trusted = has_sensor && !view.is_seen ? withoutSensor(hints) : hints;
  if (looksInward(points, normals, all, spacing, trusted, summary)) normals *= -1;
  summary.is_one_view = summary.by_sensor && (!has_sensor || view.is_only_one);
  // Also where the tetrahedra of a thin sheet tell otherwise.
  if (summary.is_one_view)
    for (int i = 0; i < n; ++i)
      if (normals.row(i).dot(hints.directions.row(i)) < 0) normals.row(i) *= -1;
  return normals;
}

}  // namespace posture
