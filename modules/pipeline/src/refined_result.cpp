// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "refined_result.h"

#include <posture/mesh/edges.h>
#include <posture/refine/partners.h>

#include <algorithm>
#include <array>
#include <map>

namespace posture {
namespace {

constexpr int FULL_ROUNDS = 5;

/// For faces of the main surface the face they were given as.
class GivenFaces {
 public:
  explicit GivenFaces(const GivenShape& shape) : shape_(shape) {
    for (int f = 0; f < shape.input.faces.rows(); ++f) {
      const auto corners = sorted(cleanCorners(f));
      if (corners[0] >= 0) faces_.emplace(corners, f);
    }
  }

  /// A place on the clean mesh, on the mesh as given.
  SurfacePoint toInput(const FacePoint& place, int clean_vertex) const {
    SurfacePoint point;
    point.vertex = shape_.clean.input_vertex[clean_vertex];
    const Eigen::Vector3i face = shape_.clean.mesh.faces.row(place.face);
    const auto found = faces_.find(sorted({face[0], face[1], face[2]}));
    if (found == faces_.end()) return point;
    point.face = found->second;
    const std::array<int, 3> corners = cleanCorners(point.face);
    for (int k = 0; k < 3; ++k)
      for (int j = 0; j < 3; ++j)
        if (corners[k] == face[j]) point.barycentric[k] = place.barycentric[j];
    return point;
  }

 private:
  using Corners = std::array<int, 3>;

  Corners cleanCorners(int input_face) const {
    Corners corners{};
    for (int k = 0; k < 3; ++k) {
      const int v = shape_.input.faces(input_face, k);
      corners[k] = shape_.clean.offset[v] > 0 ? -1 : shape_.clean.clean_vertex[v];
    }
    return corners;
  }
  static Corners sorted(Corners corners) {
    std::sort(corners.begin(), corners.end());
    return corners;
  }

  const GivenShape& shape_;
  std::map<Corners, int> faces_;
};

}  // namespace

FullMap toFullResolution(const RefinedShape& given_source,
                         const RefinedShape& target,
                         const RefinedMap& refined) {
  const RefinedShape source = rescaled(given_source, refined.scale);
  const BendableSurface a(source.full), b(target.full);
  const double softness = settlingSoftness(source.basis.eigenvalues, target.basis.eigenvalues);
  FullMap map;
  map.pair = carryUp(source.full,
                     source.work,
                     BendableSurface(source.work.mesh),
                     target.full,
                     target.work,
                     BendableSurface(target.work.mesh),
                     refined.pair);
  settle(a, b, softness, FULL_ROUNDS, map.pair);
  map.places = placesOnFaces(a, b, softness, map.pair);
  map.laid = refined.laid;
  map.without_partner = withoutPartner(a, b, map.pair, map.laid);
  return map;
}

FullMap reversed(const RefinedShape& source, const RefinedShape& target, const FullMap& map) {
  const BendableSurface a(target.full), b(source.full);
  const double softness = settlingSoftness(source.basis.eigenvalues, target.basis.eigenvalues);
  FullMap back;
  back.pair = reversed(map.pair);
  back.places = placesOnFaces(a, b, softness, back.pair);
  back.laid = map.laid;
  back.without_partner = withoutPartner(a, b, back.pair, back.laid);
  return back;
}

Vector roundTripConfidence(const TriangleMesh& source, const VertexMaps& maps) {
  const double edge = meanEdgeLength(source);
  Vector confidence(maps.forward.size());
  for (int v = 0; v < confidence.size(); ++v) {
    const int back = maps.backward[maps.forward[v]];
    const double miss = (source.vertices.row(v) - source.vertices.row(back)).norm() / (2 * edge);
    confidence[v] = 1 / (1 + miss * miss);
  }
  return confidence;
}

Correspondence correspondenceOf(const GivenShape& source,
                                const RefinedShape& source_shape,
                                const GivenShape& target,
                                const FullMap& map,
                                double trust) {
  const GivenFaces faces(target);
  const Vector confidence = roundTripConfidence(source_shape.full, map.pair.maps);
  const std::size_t n = source.clean.clean_vertex.size();
  Correspondence correspondence;
  correspondence.on_target.resize(n);
  correspondence.confidence = Vector::Zero(n);
  for (std::size_t v = 0; v < n; ++v) {
    const int clean = source.clean.clean_vertex[v];
    if (map.without_partner[clean]) continue;
    correspondence.on_target[v] = faces.toInput(map.places[clean], map.pair.maps.forward[clean]);
    correspondence.confidence[v] = trust * confidence[clean];
  }
  return correspondence;
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
