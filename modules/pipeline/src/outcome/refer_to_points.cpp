// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "outcome/refer_to_points.h"

#include <posture/core/finite_rows.h>
#include <posture/deformation/apply_deformation.h>
#include <posture/mesh/nearest_on_faces.h>
#include <posture/mesh/point_index.h>
#include <posture/mesh/position_of.h>
#include <posture/mesh/vertex_neighbors.h>

#include <tuple>
#include <utility>

namespace posture {
namespace {

/// Where points of a source surface's faces lie on the target, from where its vertices do.
class Between {
 public:
  Between(const TriangleMesh& source, const TriangleMesh& target, const Correspondence& vertices)
      : source_(source),
        target_(target),
        vertices_(vertices),
        around_(target.faces, static_cast<int>(target.vertices.rows())) {}

  /// The place for a point in a face, and its confidence. Where not all corners have a counterpart,
  /// that of the nearest corner.
  std::pair<SurfacePoint, double> operator()(const SurfacePoint& at) const {
    if (at.vertex < 0) return {};
    const auto of_vertex = [&](int v) {
      return std::pair(vertices_.on_target[v], vertices_.confidence[v]);
    };
    if (at.face < 0) return of_vertex(at.vertex);
    Eigen::Vector3d place = Eigen::Vector3d::Zero();
    double confidence = 0;
    for (int k = 0; k < 3; ++k) {
      const int corner = source_.faces(at.face, k);
      const SurfacePoint& image = vertices_.on_target[corner];
      if (image.vertex < 0) return of_vertex(at.vertex);
      place += at.barycentric[k] * positionOf(target_, image).transpose();
      confidence += at.barycentric[k] * vertices_.confidence[corner];
    }
    return {nearest(place, source_.faces.row(at.face)), confidence};
  }

 private:
  /// The nearest place in the faces around the images of the three corners.
  SurfacePoint nearest(const Eigen::Vector3d& place, const Eigen::RowVector3i& corners) const {
    NearestPlace best;
    const auto look = [&](int vertex) {
      lookAround(target_.vertices, target_.faces, around_, vertex, place, best);
    };
    for (int k = 0; k < 3; ++k) {
      const SurfacePoint& image = vertices_.on_target[corners[k]];
      look(image.vertex);
      if (image.face >= 0)
        for (int j = 0; j < 3; ++j) look(target_.faces(image.face, j));
    }
    if (best.face < 0) return vertices_.on_target[corners[0]];
    return {target_.faces(best.face, largestCorner(best.barycentric)), best.face, best.barycentric};
  }

  const TriangleMesh &source_, &target_;
  const Correspondence& vertices_;
  VertexFaces around_;
};

/// The nearest points of a cloud, outliers and missing ones left out.
class CloudPoints {
 public:
  CloudPoints(const PointCloud& cloud, const ScanSurface& scan) {
    for (int i = 0; i < cloud.points.rows(); ++i)
      if (scan.on_mesh[i].vertex >= 0) number_.push_back(i);
    Points seen(number_.size(), 3);
    for (std::size_t i = 0; i < number_.size(); ++i) seen.row(i) = cloud.points.row(number_[i]);
    index_.emplace(seen);
  }
  int nearest(const Eigen::RowVector3d& place) const {
    return number_[index_->nearest(place.transpose()).index];
  }

 private:
  std::vector<int> number_;
  std::optional<PointIndex> index_;
};

Correspondence perPoint(const ScanSurface& scan,
                        const TriangleMesh& source,
                        const TriangleMesh& target,
                        const Correspondence& vertices) {
  const Between between(source, target, vertices);
  const std::size_t n = scan.on_mesh.size();
  Correspondence points{std::vector<SurfacePoint>(n), Vector::Zero(n)};
  for (std::size_t i = 0; i < n; ++i)
    std::tie(points.on_target[i], points.confidence[i]) = between(scan.on_mesh[i]);
  return points;
}

std::vector<int> perPoint(const ScanSurface& scan, const std::vector<int>& target_vertex) {
  std::vector<int> points;
  for (const SurfacePoint& at : scan.on_mesh)
    points.push_back(at.vertex >= 0 ? target_vertex[at.vertex] : -1);
  return points;
}

/// A map between surfaces as one between the shapes they were laid through.
/// \param to_points  null: it is a mesh
Correspondence betweenShapes(const SideSurface& from,
                             const SideSurface& to,
                             const CloudPoints* to_points,
                             Correspondence map) {
  if (from.scan) map = perPoint(*from.scan, from.mesh, to.mesh, map);
  if (to_points != nullptr)
    for (SurfacePoint& place : map.on_target)
      if (place.vertex >= 0) place.vertex = to_points->nearest(positionOf(to.mesh, place));
  return map;
}

/// Vertices of a scan's surface as the points nearest to them.
void toNearestPoints(const CloudPoints& points,
                     const Points& vertices,
                     const std::vector<std::vector<int>*>& maps) {
  std::vector<int> point_at(vertices.rows());
  for (int v = 0; v < static_cast<int>(point_at.size()); ++v)
    point_at[v] = points.nearest(vertices.row(v));
  for (std::vector<int>* map : maps)
    for (int& t : *map)
      if (t >= 0) t = point_at[t];
}

/// Missing points stay so.
Points movedPoints(const TriangleMesh& surface, const Points& deformed, const PointCloud& cloud) {
  const std::vector<int> seen = finiteRows(cloud.points);
  const Points moved = applyDeformation(surface, deformed, cloud.points(seen, Eigen::all));
  Points points = cloud.points;
  points(seen, Eigen::all) = moved;
  return points;
}

}  // namespace

void referToPoints(const Shape& source,
                   const Shape& target,
                   SideSurface source_surface,
                   SideSurface target_surface,
                   RegistrationResult& result) {
  std::vector<Correspondence*> maps{&result.correspondence};
  std::vector<std::vector<int>*> vertex_maps;
  for (AlternativeSummary& alternative : result.alternatives) {
    vertex_maps.push_back(&alternative.target_vertex);
    if (!alternative.correspondence.on_target.empty()) maps.push_back(&alternative.correspondence);
  }
  for (HypothesisSummary& hypothesis : result.hypotheses)
    vertex_maps.push_back(&hypothesis.target_vertex);

  std::optional<CloudPoints> source_points, target_points;
  if (target_surface.scan) target_points.emplace(target.cloud, *target_surface.scan);
  for (Correspondence* map : maps)
    *map = betweenShapes(
        source_surface, target_surface, target_points ? &*target_points : nullptr, std::move(*map));
  if (result.back) {
    if (source_surface.scan) source_points.emplace(source.cloud, *source_surface.scan);
    result.back->correspondence = betweenShapes(target_surface,
                                                source_surface,
                                                source_points ? &*source_points : nullptr,
                                                std::move(result.back->correspondence));
  }
  if (source_surface.scan) {
    const ScanSurface& scan = *source_surface.scan;
    for (std::vector<int>* map : vertex_maps) *map = perPoint(scan, *map);
    result.surface_deformed = std::move(result.deformed);
    result.deformed = movedPoints(scan.mesh, result.surface_deformed, source.cloud);
  }
  if (target_points) toNearestPoints(*target_points, target_surface.mesh.vertices, vertex_maps);
  result.source_scan = std::move(source_surface.scan);
  result.target_scan = std::move(target_surface.scan);
}

}  // namespace posture
