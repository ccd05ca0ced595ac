// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/error.h>
#include <posture/core/rng.h>
#include <posture/mesh/half_edge_mesh.h>
#include <posture/mesh/normals.h>
#include <posture/scan/reconstruct.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/shapes.h"
#include <cmath>
#include <limits>
#include <numeric>
#include <omp.h>

namespace posture {
namespace {

PointCloud cloudOf(Points points) {
  PointCloud cloud;
  cloud.points = std::move(points);
  return cloud;
}

/// Evenly spread random points of the unit sphere, moved along the normal by noise.
Points spherePoints(int count, double noise, std::uint64_t seed = 1) {
  Rng rng(seed);
  Points points(count, 3);
  for (int i = 0; i < count; ++i) {
    const Eigen::RowVector3d direction(rng.normal(), rng.normal(), rng.normal());
    points.row(i) = (1 + noise * rng.normal()) * direction.normalized();
  }
  return points;
}

int eulerCharacteristic(const TriangleMesh& mesh) {
  const HalfEdgeMesh half_edges(mesh.faces, static_cast<int>(mesh.vertices.rows()));
  int edges = 0;
  for (int h = 0; h < half_edges.halfEdgeCount(); ++h) {
    const int twin = half_edges.twin(h);
    edges += twin < 0 || h < twin;
  }
  return static_cast<int>(mesh.vertices.rows()) - edges + static_cast<int>(mesh.faces.rows());
}

/// The constructor of HalfEdgeMesh refuses what is not manifold or not oriented.
void expectManifold(const TriangleMesh& mesh) {
  EXPECT_NO_THROW(HalfEdgeMesh(mesh.faces, static_cast<int>(mesh.vertices.rows())));
}

TEST(Reconstruct, ClosesASphereAndLooksOutwards) {
  const ScanSurface surface = reconstruct(cloudOf(spherePoints(4000, 0.002)));
  expectManifold(surface.mesh);
  EXPECT_EQ(surface.summary.components, 1);
  EXPECT_EQ(surface.summary.boundary_loops, 0);
  EXPECT_EQ(eulerCharacteristic(surface.mesh), 2);
  const Points normals = vertexNormals(surface.mesh);
  for (int v = 0; v < normals.rows(); ++v) {
    EXPECT_GT(normals.row(v).dot(surface.mesh.vertices.row(v)), 0.9);
    EXPECT_NEAR(surface.mesh.vertices.row(v).norm(), 1, 0.01);
  }
}

}  // namespace
}  // namespace posture
