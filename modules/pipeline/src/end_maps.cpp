// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "end_maps.h"

#include <posture/refine/rigid_ends.h>
#include <posture/refine/tip_maps.h>

#include <algorithm>

namespace posture {
namespace {

/// So many different finalists are looked at.
constexpr std::size_t MOST_LOOKED_AT = 4;

/// Vertices of `work` on the coarse mesh.
std::vector<int> onCoarse(const RefinedShape& shape, std::vector<int> vertices) {
  for (int& v : vertices) v = shape.coarse.nearest[v];
  return vertices;
}

/// Samples x landmarks, geodesic.
template <class Side>
Matrix distancesFrom(const SpectralSurface& surface,
                     const std::vector<int>& samples,
                     const std::vector<Landmark>& landmarks,
                     const Side& side) {
  Matrix distances(samples.size(), landmarks.size());
  for (std::size_t k = 0; k < landmarks.size(); ++k) {
    const std::vector<double>& from_it = surface.distances.from(side(landmarks[k]));
    for (std::size_t i = 0; i < samples.size(); ++i) distances(i, k) = from_it[samples[i]];
  }
  return distances;
}

/// The tips that are in none of the ends.
std::vector<Landmark> otherTips(const std::vector<int>& tips,
                                const std::vector<RigidEnd>& ends,
                                const VertexMaps& maps) {
  std::vector<Landmark> others;
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
    std::vector<Landmark> landmarks = otherTips(tips, ends, maps);
    for (const RigidEnd& end : ends)
      landmarks.insert(landmarks.end(), end.landmarks.begin(), end.landmarks.end());
    found.push_back(mapBetweenLandmarks(
        source_shape.samples,
        distancesFrom(source, source_samples, landmarks, [](const Landmark& l) { return l.a; }),
        target_shape.samples,
        distancesFrom(target, target_samples, landmarks, [](const Landmark& l) { return l.b; })));
  }
  return found;
}

}  // namespace posture
