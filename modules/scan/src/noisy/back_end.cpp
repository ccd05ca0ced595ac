// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "noisy/back_end.h"

#include <posture/core/error.h>
#include <posture/mesh/half_edge_mesh.h>
#include <posture/mesh/normals.h>
#include <posture/mesh/point_index.h>

#include <Eigen/Geometry>

#include "noisy/agreement.h"
#include "noisy/tangent_delaunay.h"
#include "pcl/pcl_surfaces.h"
#include "points/neighbors.h"
#include "points/spacing.h"
#include "surface/doubts.h"
#include "surface/finished_surface.h"
#include <algorithm>

namespace posture {
namespace {

/// Faces the way the normals of the nearest samples look.
void orientBySamples(const OrientedPoints& samples, TriangleMesh& mesh) {
  const PointIndex index(samples.points);
  for (int f = 0; f < mesh.faces.rows(); ++f) {
    const Eigen::RowVector3d a = mesh.vertices.row(mesh.faces(f, 0)),
                             b = mesh.vertices.row(mesh.faces(f, 1)),
                             c = mesh.vertices.row(mesh.faces(f, 2));
    const auto near = index.nearest((a + b + c).transpose() / 3);
    if ((b - a).cross(c - a).dot(samples.normals.row(near.index)) < 0)
      std::swap(mesh.faces(f, 1), mesh.faces(f, 2));
  }
}

TriangleMesh tangentSurface(const OrientedPoints& samples,
                            const NeighborSearch& search,
                            const NeighborTable& neighbors,
                            const Spacing& spacing) {
  return {samples.points,
          agreeingFaces(samples, tangentDelaunay(samples, search, neighbors, spacing))};
}

/// PCL's surfaces, cut where they are not manifold and turned alike.
TriangleMesh untangled(const OrientedPoints& samples, TriangleMesh mesh) {
  orientBySamples(samples, mesh);
  return cutNonManifold(mesh).mesh;
}

}  // namespace

TriangleMesh meshSamples(const OrientedPoints& samples,
                         SurfaceMethod method,
                         ReconstructionSummary& summary) {
  constexpr int FEWEST = 4, NEIGHBORS = 32;
  if (samples.points.rows() < FEWEST) throw InputError("shows no surface");
  const NeighborSearch search(samples.points);
  const NeighborTable neighbors = search.table(NEIGHBORS);
  const Spacing h = spacing(samples.points, neighbors);
  summary.mesh_spacing = h.median;
  TriangleMesh mesh;
  switch (method) {
    case SurfaceMethod::TANGENT_DELAUNAY:
    case SurfaceMethod::MLS:
      mesh = tangentSurface(samples, search, neighbors, h);
      break;
    case SurfaceMethod::POISSON:
      mesh = untangled(samples, poissonSurface(samples, neighbors, h.median));
      break;
    case SurfaceMethod::GREEDY:
      mesh = untangled(samples, greedySurface(samples, h.median));
      break;
  }
  std::vector<int> kept;
  mesh = repaired(std::move(mesh), h.median, kept, summary.dropped_pieces);
  if (mesh.faces.rows() == 0) throw InputError("shows no surface");
  describe(mesh, h.median, summary);
  summary.contacts = possibleContacts(mesh, vertexNormals(mesh), h.median);
  return mesh;
}

}  // namespace posture
