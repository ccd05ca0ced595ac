// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "whole_source.h"

#include <posture/deformation/completion.h>
#include <posture/deformation/extend_deformation.h>

#include <stdexcept>
#include <utility>

namespace posture {
namespace {

bool touchesPatch(const GivenShape& given, const Eigen::RowVector3i& face) {
  return given.isPatch(face[0]) || given.isPatch(face[1]) || given.isPatch(face[2]);
}

Correspondence matchesOf(const TriangleMesh& source, const FullMap& map) {
  const std::size_t n = map.places.size();
  Correspondence matches{std::vector<SurfacePoint>(n), roundTripConfidence(source, map.pair.maps)};
  for (std::size_t v = 0; v < n; ++v)
    if (map.without_partner[v] == 0)
      matches.on_target[v] = {
          map.pair.maps.forward[v], map.places[v].face, map.places[v].barycentric};
  return matches;
}

Faces withoutPatches(const GivenShape& given, const Faces& faces) {
  std::vector<int> own;
  for (int f = 0; f < faces.rows(); ++f)
    if (!touchesPatch(given, faces.row(f))) own.push_back(f);
  return faces(own, Eigen::all);
}

/// What has no partner, or one in a hole that was closed: a patch is flatter than the body.
std::vector<char> withoutOwnPartner(const GivenShape& target,
                                    const Faces& faces,
                                    const FullMap& map) {
  std::vector<char> without = map.without_partner;
  for (std::size_t v = 0; v < without.size(); ++v)
    if (touchesPatch(target, faces.row(map.places[v].face))) without[v] = 1;
  return without;
}

}  // namespace

Points placesOfWhole(const PosedSide& source,
                     const RefinedShape& scaled,
                     const PosedSide& target,
                     const FullMap& map) {
  const TriangleMesh &whole = scaled.full, &onto = target.shape.full;
  try {
    Completion completion =
        completeDeformation(whole, map.pair.bent_a, matchesOf(whole, map), onto);
    if (completion.places.allFinite())
      return extendDeformation(
          {completion.scale * whole.vertices, withoutPatches(source.given, whole.faces)},
          std::move(completion.places),
          withoutOwnPartner(target.given, onto.faces, map));
  } catch (const std::invalid_argument&) {  // no shape to encode: all in one line
  }
  return map.pair.bent_a;
}

}  // namespace posture
