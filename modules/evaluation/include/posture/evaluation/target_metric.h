// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/correspondence.h>
#include <posture/core/types.h>
#include <posture/geodesic/fast_marching.h>
#include <posture/mesh/areas.h>
#include <posture/mesh/clean_mesh.h>
#include <posture/mesh/vertex_neighbors.h>

#include <cstdint>
#include <vector>

namespace posture {

/// Something to measure on a target mesh, in that mesh's own numbering.
struct Route {
  int from = 0;     ///< vertex
  SurfacePoint to;  ///< a face and barycentric coordinates, or face -1 and a vertex
};

struct RouteLengths {
  std::vector<double> length;         ///< one a route, in mesh units
  std::int64_t settled_vertices = 0;  ///< by all fronts together: what the measuring cost
};

/// Distances on a target mesh as it was given, loose parts included, but for seams, which are
/// closed, and spikes, which are set back, as when it is registered: they are taken along the main
/// surface, and a vertex off it is its offset away from the surface vertex it follows.
class TargetMetric {
 public:
  /// \throws InputError  the mesh has no usable face; std::invalid_argument  as requireMesh().
  explicit TargetMetric(TriangleMesh target);

  int vertexCount() const { return static_cast<int>(target_.vertices.rows()); }
  int faceCount() const { return static_cast<int>(target_.faces.rows()); }
  double rootArea() const { return root_area_; }  ///< square root of the main surface's area

  /// Geodesic lengths; inside a face, interpolated between its corners. One front for all routes
  /// from the same vertex, stopped as soon as the last of their ends is reached.
  /// \throws std::invalid_argument  no such vertex or face.
  RouteLengths geodesics(const std::vector<Route>& routes) const;

  /// The least number of edges from `from` to the vertex of `to`. The way from a loose vertex to
  /// the surface counts as one edge.
  std::vector<int> edgeCounts(const std::vector<Route>& routes) const;

 private:
  void check(const std::vector<Route>& routes) const;
  std::vector<std::vector<int>> groupByStart(const std::vector<Route>& routes) const;
  bool samePlace(int a, int b) const;
  double lengthTo(int from, int to, const GeodesicField& field) const;
  double lengthTo(int from, const SurfacePoint& to, const GeodesicField& field) const;
  void appendGoals(const SurfacePoint& to, std::vector<int>& goals) const;

  TriangleMesh target_;
  CleanMesh surface_;
  FastMarching marching_;
  VertexNeighbors neighbors_;  // of the clean vertices
  double root_area_ = 0;
};

}  // namespace posture
