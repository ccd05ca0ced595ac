// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "outcome/left_out_parts.h"

#include <posture/mesh/areas.h>
#include <posture/mesh/connected_parts.h>
#include <posture/mesh/weld.h>

#include <algorithm>
#include <vector>

namespace posture {
namespace {

/// Of the pieces of a side the area of the largest that has no place, over the main surface's.
/// \param has_place  of each vertex of the input.
double leftOutShare(const CleanMesh& clean, const std::vector<char>& has_place) {
  // A source may be coarser than the target, of which it then reaches few vertices.
  constexpr double SOME = 0.05;
  const ConnectedParts parts = connectedParts(clean.pieces);
  std::vector<double> corners(parts.area.size(), 0), placed(parts.area.size(), 0);
  for (int f = 0; f < clean.pieces.faces.rows(); ++f)
    for (int v : clean.pieces.faces.row(f)) {
      ++corners[parts.of_face[f]];
      placed[parts.of_face[f]] += has_place[clean.piece_vertex[v]];
    }
  double largest = 0;
  for (std::size_t part = 0; part < parts.area.size(); ++part)
    if (placed[part] < SOME * corners[part]) largest = std::max(largest, parts.area[part]);
  return largest / surfaceArea(clean.mesh);
}

}  // namespace

void noteLeftOutParts(const GivenShape& source,
                      const GivenShape& target,
                      RegistrationResult& result) {
  std::vector<char> leads(source.input.vertices.rows(), 0),
      is_reached(target.input.vertices.rows(), 0);
  const std::vector<SurfacePoint>& places = result.correspondence.on_target;
  const std::vector<int> first = weld(target.input.vertices);
  for (std::size_t v = 0; v < places.size(); ++v) {
    if (places[v].vertex < 0) continue;
    leads[v] = 1;
    is_reached[first[places[v].vertex]] = 1;
    if (places[v].face >= 0)
      for (int corner : target.input.faces.row(places[v].face)) is_reached[first[corner]] = 1;
  }
  result.source.left_out_share = leftOutShare(source.clean, leads);
  result.target.left_out_share = leftOutShare(target.clean, is_reached);
}

}  // namespace posture
