// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "refined/finalists/end_maps.h"

#include <posture/refine/rigid_ends.h>
#include <posture/refine/tip_maps.h>

#include <algorithm>

namespace posture {
namespace {

/// How many different finalists are looked at.
constexpr std::size_t MOST_LOOKED_AT = 4;

/// How many ends of limbs tell where the rest of a body is.
constexpr std::size_t FEWEST_ENDS = 4;

/// Vertices of `work` on the coarse mesh.
std::vector<int> onCoarse(const RefinedShape& shape, std::vector<int> vertices) {
  for (int& v : vertices) v = shape.coarse.nearest[v];
  return vertices;
}

/// Geodesic, samples x known places.
template <class Side>
Matrix distancesFrom(const SpectralSurface& surface,
                     const std::vector<int>& samples,
                     const std::vector<PlacePair>& known,
                     const Side& side) {
  Matrix distances(samples.size(), known.size());
  for (std::size_t k = 0; k < known.size(); ++k) {
    const std::vector<double>& from_it = surface.distances.from(side(known[k]));
    for (std::size_t i = 0; i < samples.size(); ++i) distances(i, k) = from_it[samples[i]];
  }
  return distances;
}

/// The tips that are in none of the ends.
std::vector<PlacePair> otherTips(const std::vector<int>& tips,
                                 const std::vector<RigidEnd>& ends,
                                 const VertexMaps& maps) {
  std::vector<PlacePair> others;
  for (int tip : tips)
    if (std::none_of(ends.begin(), ends.end(), [&](const RigidEnd& end) {
          return std::find(end.vertices.begin(), end.vertices.end(), tip) != end.vertices.end();
        }))
      others.push_back({tip, maps.forward[tip]});
  return others;
}

}  // namespace

std::vector<SampleMap> endMaps(const RefinedShape& source_shape,
                               const RefinedShape& target_shape,
                               const SpectralSurface& source,
                               const SpectralSurface& target,
                               const std::vector<Finalist>& finalists,
                               const std::vector<int>& distinct) {
  const std::vector<int> tips = onCoarse(source_shape, source_shape.tips());
  const std::vector<int> source_samples = onCoarse(source_shape, source_shape.sample_vertex),
                         target_samples = onCoarse(target_shape, target_shape.sample_vertex);
  std::vector<SampleMap> found;
  for (std::size_t k = 0; k < std::min(MOST_LOOKED_AT, distinct.size()); ++k) {
    const VertexMaps& maps = finalists[distinct[k]].maps;
    const std::vector<RigidEnd> ends = rigidEnds(source, target, tips, maps);
    if (std::none_of(ends.begin(), ends.end(), [](const RigidEnd& end) { return end.turned; }))
      continue;
    std::vector<PlacePair> known = otherTips(tips, ends, maps);
    if (known.size() + ends.size() < FEWEST_ENDS) continue;
    for (const RigidEnd& end : ends)
      known.insert(known.end(), end.places.begin(), end.places.end());
    found.push_back(mapBetweenPlaces(
        source_shape.samples,
        distancesFrom(source, source_samples, known, [](const PlacePair& l) { return l.a; }),
        target_shape.samples,
        distancesFrom(target, target_samples, known, [](const PlacePair& l) { return l.b; })));
  }
  return found;
}

}  // namespace posture
