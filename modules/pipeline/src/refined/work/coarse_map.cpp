// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "refined/work/coarse_map.h"

#include <posture/core/parallel.h>
#include <posture/mesh/edges.h>
#include <posture/mesh/position_of.h>

#include "no_way_on.h"
#include <algorithm>
#include <vector>

namespace posture {
namespace {

/// Where the answer takes the source's full mesh, in the frame of the target.
struct KnownPlaces {
  Points place;
  std::vector<int> match;   ///< vertex of the coarse target
  std::vector<char> apart;  ///< whether the vertex has none on the target's main surface
};

KnownPlaces placesOfOwn(const PosedSide& source,
                        const PosedSide& target,
                        const RegistrationResult& known) {
  const RefinedShape& to = target.shape;
  const auto n = source.shape.full.vertices.rows();
  KnownPlaces there{Points(n, 3), std::vector<int>(n, 0), std::vector<char>(n, 1)};
  for (std::size_t v = 0; v < source.ordered.input_vertex.size(); ++v) {
    const int input = source.ordered.input_vertex[v];
    const SurfacePoint& place = known.correspondence.on_target[input];
    const bool is_mapped = place.vertex >= 0;
    there.place.row(static_cast<Eigen::Index>(v)) =
        target.pose.into(is_mapped ? positionOf(target.given.input, place)
                                   : Eigen::RowVector3d(known.deformed.row(input)));
    if (!is_mapped || !target.ordered.isOnMain(place.vertex)) continue;
    there.apart[v] = 0;
    there.match[v] = to.coarse.nearest[to.work.nearest[target.ordered.clean_vertex[place.vertex]]];
  }
  return there;
}

/// Vertices put on long edges lie between those of the face they are in.
void addBetween(const PosedSide& source, KnownPlaces& there) {
  const RefinedShape& shape = source.shape;
  const auto own = static_cast<int>(source.ordered.input_vertex.size());
  for (std::size_t f = 0; f < shape.parts.size(); ++f) {
    const auto corners = source.ordered.mesh.faces.row(shape.parts[f].face);
    for (int k = 0; k < 3; ++k) {
      const int v = shape.full.faces(static_cast<Eigen::Index>(f), k);
      if (v < own) continue;
      const Eigen::Vector3d at = shape.parts[f].corners.col(k);
      Eigen::Index nearest = 0;
      at.maxCoeff(&nearest);
      there.place.row(v) = at.transpose() * there.place(corners, Eigen::all);
      there.match[v] = there.match[corners[nearest]];
      there.apart[v] = 0;
      for (int j = 0; j < 3; ++j)
        if (at[j] > 0 && there.apart[corners[j]] != 0) there.apart[v] = 1;
    }
  }
}

/// Where the answer takes the coarse source.
void goThere(const PosedSide& source,
             const PosedSide& target,
             const RegistrationResult& known,
             BentPair& pair) {
  const RefinedShape& from = source.shape;
  KnownPlaces there = placesOfOwn(source, target, known);
  addBetween(source, there);
  std::vector<int> full;
  for (int v : from.coarse.vertex) full.push_back(from.work.vertex[v]);
  pair.bent_a = there.place(full, Eigen::all);
  for (int v : full) {
    pair.maps.forward.push_back(there.match[v]);
    pair.apart_a.push_back(there.apart[v]);
  }
}

/// Back to the vertices of the source that come to lie nearest.
void goBack(const TriangleMesh& source, const TriangleMesh& target, BentPair& pair) {
  const Points& to = target.vertices;
  std::vector<int> mapped;
  for (int v = 0; v < pair.bent_a.rows(); ++v)
    if (pair.apart_a[v] == 0) mapped.push_back(v);
  if (mapped.empty()) throw NoWayOn("the answer maps nothing");
  const double near = std::max(meanEdgeLength(source), meanEdgeLength(target));
  pair.maps.backward.assign(to.rows(), 0);
  pair.apart_b.assign(to.rows(), 1);
  pair.bent_b.resize(to.rows(), 3);
  parallelFor(static_cast<int>(to.rows()), [&](int t) {
    const auto distance = [&](int v) { return (pair.bent_a.row(v) - to.row(t)).squaredNorm(); };
    const int nearest = *std::min_element(
        mapped.begin(), mapped.end(), [&](int v, int w) { return distance(v) < distance(w); });
    pair.maps.backward[t] = nearest;
    pair.bent_b.row(t) = source.vertices.row(nearest);
    if (distance(nearest) < near * near) pair.apart_b[t] = 0;
  });
}

}  // namespace

BentPair coarseMapOf(const PosedSide& source,
                     const PosedSide& target,
                     const RegistrationResult& known) {
  BentPair pair;
  goThere(source, target, known, pair);
  goBack(source.shape.coarse.mesh, target.shape.coarse.mesh, pair);
  return pair;
}

std::vector<int> coarseToInput(const VertexMaps& maps,
                               const GivenShape& source,
                               const RefinedShape& source_shape,
                               const GivenShape& target,
                               const RefinedShape& target_shape) {
  std::vector<int> clean(source_shape.full.vertices.rows());
  for (std::size_t v = 0; v < clean.size(); ++v) {
    const int coarse = source_shape.coarse.nearest[source_shape.work.nearest[v]];
    clean[v] = target_shape.work.vertex[target_shape.coarse.vertex[maps.forward[coarse]]];
  }
  return toInput(clean, source.clean, target.clean);
}

}  // namespace posture
