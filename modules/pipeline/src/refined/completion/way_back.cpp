// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "refined/completion/way_back.h"

#include <posture/mesh/areas.h>
#include <posture/mesh/position_of.h>

#include "refined/refinement/refined_result.h"
#include <algorithm>
#include <numeric>
#include <optional>
#include <vector>

namespace posture {
namespace {

/// Where the way back leads from a place on the target, straight between those of the face's
/// corners; from the nearest vertex where not all have one.
std::optional<Eigen::RowVector3d> leadsTo(const SurfacePoint& place,
                                          const TriangleMesh& source,
                                          const TriangleMesh& target,
                                          const Correspondence& back) {
  if (place.vertex < 0) return std::nullopt;
  Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
  bool whole = place.face >= 0;
  for (int k = 0; k < 3 && whole; ++k) {
    const SurfacePoint& corner = back.on_target[target.faces(place.face, k)];
    whole = corner.vertex >= 0;
    if (whole) sum += place.barycentric[k] * positionOf(source, corner);
  }
  if (whole) return sum;
  const SurfacePoint& nearest = back.on_target[place.vertex];
  if (nearest.vertex < 0) return std::nullopt;
  return positionOf(source, nearest);
}

}  // namespace

void measureMiss(const GivenShape& source,
                 const TriangleMesh& target,
                 const Correspondence& there,
                 WayBack& back) {
  back.mean_miss = back.percentile_95_miss = 0;
  std::vector<double> miss;
  for (int v = 0; v < source.input.vertices.rows(); ++v) {
    if (!source.clean.isOnMain(v)) continue;
    const auto end = leadsTo(there.on_target[v], source.input, target, back.correspondence);
    if (end) miss.push_back((*end - source.input.vertices.row(v)).norm());
  }
  if (miss.empty()) return;
  const double size = rootArea(source.clean.mesh);
  const auto n = miss.size();
  back.mean_miss = std::accumulate(miss.begin(), miss.end(), 0.0) / static_cast<double>(n) / size;
  const auto at_95 = miss.begin() + static_cast<std::ptrdiff_t>(n * 95 / 100);
  std::nth_element(miss.begin(), at_95, miss.end());
  back.percentile_95_miss = *at_95 / size;
}

TargetOnSource targetOnSource(const PosedSide& source,
                              const RefinedShape& scaled,
                              const PosedSide& target,
                              const FullMap& there,
                              double scale,
                              double trust) {
  const FullMap map = reversed(scaled, target.shape, there);
  TargetOnSource found;
  LaidSide& back = found.target;
  back.scale = 1 / scale;
  back.trust = trust;
  back.correspondence =
      correspondenceOf(target.given, target.shape, source.given, scaled, map, trust);
  back.deformed = source.pose.outOf(placesOfInput(target.given,
                                                  target.shape.full,
                                                  std::vector<char>(map.places.size(), 1),
                                                  map.pair.bent_a,
                                                  target.pose.into(target.given.input.vertices)));
  found.pieces = placeLoosePieces(target.given, source.given, back);
  return found;
}

}  // namespace posture
