// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "whole_source.h"

#include <posture/deformation/completion.h>

#include <stdexcept>

namespace posture {
namespace {

Correspondence matchesOf(const TriangleMesh& source, const FullMap& map) {
  const std::size_t n = map.places.size();
  Correspondence matches{std::vector<SurfacePoint>(n), roundTripConfidence(source, map.pair.maps)};
  for (std::size_t v = 0; v < n; ++v)
    if (map.without_partner[v] == 0)
      matches.on_target[v] = {
          map.pair.maps.forward[v], map.places[v].face, map.places[v].barycentric};
  return matches;
}

}  // namespace

Points placesOfWhole(const TriangleMesh& source, const TriangleMesh& target, const FullMap& map) {
  try {
    Points places =
        completeDeformation(source, map.pair.bent_a, matchesOf(source, map), target).places;
    if (places.allFinite()) return places;
  } catch (const std::invalid_argument&) {  // no shape to encode: all in one line
  }
  return map.pair.bent_a;
}

}  // namespace posture
