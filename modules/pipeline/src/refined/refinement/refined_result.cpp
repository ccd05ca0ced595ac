// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "refined/refinement/refined_result.h"

#include <posture/mesh/edges.h>
#include <posture/refine/partners.h>

#include <algorithm>
#include <array>
#include <map>

namespace posture {
namespace {

/// For places on a side's meshes those on the mesh as it was given.
class GivenFaces {
 public:
  GivenFaces(const GivenShape& given, const RefinedShape& shape) : given_(given), shape_(shape) {
    for (int f = 0; f < given.input.faces.rows(); ++f) {
      const auto corners = sorted(cleanCorners(f));
      if (corners[0] >= 0) faces_.emplace(corners, f);
    }
  }

  /// \param vertex  of the full mesh: the one that fits best.
  SurfacePoint toInput(const FacePoint& on_full, int vertex) const {
    const FacePoint place = shape_.onMainSurface(on_full);
    const Eigen::Vector3i face = given_.clean.mesh.faces.row(place.face);
    SurfacePoint point;
    point.vertex = given_.clean.input_vertex[isAdded(vertex) ? nearestCorner(place) : vertex];
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

  bool isAdded(int vertex) const { return vertex >= given_.clean.mesh.vertices.rows(); }

  /// A vertex of the main surface.
  int nearestCorner(const FacePoint& place) const {
    const TriangleMesh& mesh = given_.clean.mesh;
    const Eigen::Vector3i face = mesh.faces.row(place.face);
    Eigen::Matrix3d corners;
    for (int k = 0; k < 3; ++k) corners.row(k) = mesh.vertices.row(face[k]);
    int nearest = 0;
    (corners.rowwise() - place.barycentric.transpose() * corners)
        .rowwise()
        .squaredNorm()
        .minCoeff(&nearest);
    return face[nearest];
  }

  Corners cleanCorners(int input_face) const {
    Corners corners{};
    for (int k = 0; k < 3; ++k) {
      const int v = given_.input.faces(input_face, k);
      corners[k] = given_.clean.isOnMain(v) ? given_.clean.clean_vertex[v] : -1;
    }
    return corners;
  }
  static Corners sorted(Corners corners) {
    std::sort(corners.begin(), corners.end());
    return corners;
  }

  const GivenShape& given_;
  const RefinedShape& shape_;
  std::map<Corners, int> faces_;
};

}  // namespace

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
                                const RefinedShape& target_shape,
                                const FullMap& map,
                                double trust) {
  const GivenFaces faces(target, target_shape);
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

Correspondence roughCorrespondenceOf(const GivenShape& source,
                                     const RefinedShape& source_shape,
                                     const GivenShape& target,
                                     const RefinedShape& target_shape,
                                     const RefinedMap& map) {
  const std::vector<char> without = withoutPartner(BendableSurface(source_shape.work.mesh),
                                                   BendableSurface(target_shape.work.mesh),
                                                   map.pair,
                                                   {map.found.laid});  // what is astray tells, too
  const std::size_t n = source.clean.clean_vertex.size();
  Correspondence correspondence;
  correspondence.on_target.resize(n);
  correspondence.confidence = Vector::Zero(n);
  for (std::size_t v = 0; v < n; ++v) {
    const int work = source_shape.work.nearest[source.clean.clean_vertex[v]];
    if (!source.clean.isOnMain(v) || without[work]) continue;
    correspondence.on_target[v].vertex =
        target.clean.input_vertex[target_shape.work.vertex[map.pair.maps.forward[work]]];
    correspondence.confidence[v] = 1;
  }
  return correspondence;
}

}  // namespace posture
