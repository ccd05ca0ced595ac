// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "refined/refinement/full_resolution.h"

#include <posture/core/parallel.h>
#include <posture/refine/carry_up.h>
#include <posture/refine/partners.h>
#include <posture/refine/settle.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace posture {
namespace {

/// Of polishing: from the work mesh on, and from a level in between to all vertices.
constexpr int ROUNDS = 20, LAST_ROUNDS = 10;

/// Largest ratio of vertices between a level and the one below: matches slide from edge to edge.
constexpr double MOST_FINER = 12;

/// The full mesh reduced less. \param way  from the work mesh, 0, to the full one, 1.
ReducedMesh lessReduced(const RefinedShape& shape, double way) {
  const auto work = static_cast<double>(shape.work.mesh.vertices.rows());
  const auto full = static_cast<double>(shape.full.vertices.rows());
  return reduceMesh(shape.full, static_cast<int>(work * std::pow(full / work, way)));
}

/// A lower level as the reduction of a higher one, both of the same mesh.
ReducedMesh within(const ReducedMesh& higher, const ReducedMesh& lower) {
  ReducedMesh reduced{lower.mesh, {}, {}};
  for (int v : lower.vertex) reduced.vertex.push_back(higher.nearest[v]);
  for (int v : higher.vertex) reduced.nearest.push_back(lower.nearest[v]);
  return reduced;
}

}  // namespace

int levelsBetween(const RefinedShape& shape) {
  const double finer = static_cast<double>(shape.full.vertices.rows()) /
                       static_cast<double>(shape.work.mesh.vertices.rows());
  return std::max(0, static_cast<int>(std::ceil(std::log(finer) / std::log(MOST_FINER))) - 1);
}

FullMap toFullResolution(const RefinedShape& given_source,
                         const RefinedShape& target,
                         const RefinedMap& refined) {
  const RefinedShape source = rescaled(given_source, refined.scale);
  const double softness = settlingSoftness(source.basis.eigenvalues, target.basis.eigenvalues);
  BentPair pair = refined.pair;
  ReducedMesh below_a = source.work, below_b = target.work;
  const int between = std::max(levelsBetween(source), levelsBetween(target));
  for (int level = 1; level <= between; ++level) {
    const double way = level / (between + 1.0);
    std::array<ReducedMesh, 2> here;
    parallelFor(2, [&](int side) { here[side] = lessReduced(side == 0 ? source : target, way); });
    pair = carryUp(
        here[0].mesh, within(here[0], below_a), here[1].mesh, within(here[1], below_b), pair);
    polish(BendableSurface(here[0].mesh), BendableSurface(here[1].mesh), softness, ROUNDS, pair);
    below_a = std::move(here[0]);
    below_b = std::move(here[1]);
  }
  const BendableSurface a(source.full), b(target.full);
  FullMap map;
  map.pair = carryUp(source.full, below_a, target.full, below_b, pair);
  polish(a, b, softness, between > 0 ? LAST_ROUNDS : ROUNDS, map.pair);
  map.places = placesOnFaces(a, b, softness, map.pair);
  map.found = refined.found;
  map.without_partner = withoutPartner(a, b, map.pair, map.found);
  return map;
}

FullMap reversed(const RefinedShape& source, const RefinedShape& target, const FullMap& map) {
  const BendableSurface a(target.full), b(source.full);
  const double softness = settlingSoftness(source.basis.eigenvalues, target.basis.eigenvalues);
  FullMap back;
  back.pair = reversed(map.pair);
  back.places = placesOnFaces(a, b, softness, back.pair);
  back.found = map.found;
  back.without_partner = withoutPartner(a, b, back.pair, back.found);
  return back;
}

}  // namespace posture
