// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "extended_finalist.h"

#include <posture/core/parallel.h>
#include <posture/mesh/edges.h>
#include <posture/mesh/position_of.h>
#include <posture/refine/extend_map.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace posture {
namespace {

/// Where the answer takes the coarse source.
void goThere(const CoarseSides& sides, const RegistrationResult& known, BentPair& pair) {
  const PosedSide &source = sides.source_side, &target = sides.target_side;
  const RefinedShape &from = source.shape, &to = target.shape;
  const auto n = sides.source.mesh.vertices.rows();
  const auto own = static_cast<int>(source.ordered.input_vertex.size());
  pair.maps.forward.assign(n, 0);
  pair.apart_a.assign(n, 1);
  pair.bent_a = sides.source.mesh.vertices;
  for (int v = 0; v < n; ++v) {
    const int whole = from.work.vertex[from.coarse.vertex[v]];
    if (whole >= own) continue;  // put on a long edge
    const int input = source.ordered.input_vertex[whole];
    const SurfacePoint& place = known.correspondence.on_target[input];
    if (place.vertex < 0) {
      pair.bent_a.row(v) = target.pose.into(known.deformed.row(input));
      continue;
    }
    pair.apart_a[v] = 0;
    pair.bent_a.row(v) = target.pose.into(positionOf(target.given.input, place));
    pair.maps.forward[v] =
        to.coarse.nearest[to.work.nearest[target.ordered.clean_vertex[place.vertex]]];
  }
}

/// Back to the vertices of the source that come to lie nearest.
void goBack(const CoarseSides& sides, BentPair& pair) {
  const Points& to = sides.target.mesh.vertices;
  std::vector<int> mapped;
  for (int v = 0; v < pair.bent_a.rows(); ++v)
    if (pair.apart_a[v] == 0) mapped.push_back(v);
  if (mapped.empty()) throw std::runtime_error("the answer maps nothing");
  const double near =
      std::max(meanEdgeLength(sides.source.mesh), meanEdgeLength(sides.target.mesh));
  pair.maps.backward.assign(to.rows(), 0);
  pair.apart_b.assign(to.rows(), 1);
  pair.bent_b.resize(to.rows(), 3);
  parallelFor(static_cast<int>(to.rows()), [&](int t) {
    const auto distance = [&](int v) { return (pair.bent_a.row(v) - to.row(t)).squaredNorm(); };
    const int nearest = *std::min_element(
        mapped.begin(), mapped.end(), [&](int v, int w) { return distance(v) < distance(w); });
    pair.maps.backward[t] = nearest;
    pair.bent_b.row(t) = sides.source.mesh.vertices.row(nearest);
    if (distance(nearest) < near * near) pair.apart_b[t] = 0;
  });
}

/// The answer as it is; what has no counterpart in it is apart.
BentPair mapOfKnown(const CoarseSides& sides, const RegistrationResult& known) {
  BentPair pair;
  goThere(sides, known, pair);
  goBack(sides, pair);
  return pair;
}

}  // namespace

Finalist extendedFinalist(const CoarseSides& sides, const RegistrationResult& known) {
  const SpectralSurface &source = sides.source, &target = sides.target;
  ScoredPair extended = extendMap(source,
                                  target,
                                  settlingSoftness(source.eigenvalues, target.eigenvalues),
                                  mapOfKnown(sides, known));
  Finalist finalist;
  finalist.maps = extended.pair.maps;
  finalist.orientation = orientation(source, target, finalist.maps);
  finalist.score = extended.score;
  if (finalist.orientation <= LEAST_ORIENTATION || !std::isfinite(finalist.score.total()))
    throw std::runtime_error("the answer does not go on");
  finalist.bent = std::move(extended.pair);
  return finalist;
}

}  // namespace posture
