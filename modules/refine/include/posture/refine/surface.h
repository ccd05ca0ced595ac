// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/types.h>
#include <posture/deformation/arap.h>
#include <posture/geodesic/distance_rows.h>
#include <posture/mesh/vertex_neighbors.h>
#include <posture/spectral/laplacian.h>

#include <vector>

namespace posture {

/// A surface that can be bent onto another one. Both of a pair are in one unit, of which the
/// square root of their area is about one.
struct BendableSurface {
  explicit BendableSurface(TriangleMesh mesh);

  TriangleMesh mesh;
  Points normals;  ///< n x 3, unit
  VertexNeighbors neighbors, within_two_edges;
  VertexFaces faces_around;
  std::vector<char> on_boundary;  ///< n
  Laplacian laplacian;
  Arap arap;
};

/// The share of its area that belongs to the vertices marked. \param marked  n, or empty: none.
double areaShare(const BendableSurface& surface, const std::vector<char>& marked);

/// A surface with its smoothest functions.
struct SpectralSurface : BendableSurface {
  /// \param functions  n x k, computed on this mesh or on a finer one with all its vertices.
  SpectralSurface(TriangleMesh mesh, const Matrix& functions, Vector eigenvalues);

  Eigen::MatrixXf functions;  ///< n x k. Single precision: maps are no more exact than an edge
  Vector eigenvalues;         ///< k
  Eigen::MatrixXf gram;       ///< k x k, inner products of the functions on this mesh
  DistanceRows distances;     ///< geodesic
};

/// A map between the vertices of two surfaces, both ways.
struct VertexMaps {
  std::vector<int> forward;
  std::vector<int> backward;
};

}  // namespace posture
