// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/error.h>
#include <posture/mesh/normals.h>
#include <posture/refine/surface.h>

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

namespace posture {

BendableSurface::BendableSurface(TriangleMesh surface)
    : mesh(std::move(surface)),
      normals(vertexNormals(mesh)),
      neighbors(mesh.faces, static_cast<int>(mesh.vertices.rows())),
      faces_around(mesh.faces, static_cast<int>(mesh.vertices.rows())),
      on_boundary(boundaryVertices(mesh.faces, static_cast<int>(mesh.vertices.rows()))),
      laplacian(cotangentLaplacian(mesh)),
      arap(mesh, laplacian) {}

SpectralSurface::SpectralSurface(TriangleMesh surface, const Matrix& basis, Vector values)
    : BendableSurface(std::move(surface)),
      functions(basis.cast<float>()),
      eigenvalues(std::move(values)),
      marching(mesh) {
  require(functions.rows() == mesh.vertices.rows() && functions.cols() == eigenvalues.size(),
          "SpectralSurface: one row a vertex, one eigenvalue a function");
  const int samples = std::min(DISTANCE_SAMPLES, static_cast<int>(mesh.vertices.rows()));
  std::vector<int> first(samples);
  std::iota(first.begin(), first.end(), 0);
  distances.resize(samples, samples);
  GeodesicField field;
  for (int i : first) {
    marching.marchUntil(i, first, field);
    for (int j : first) distances(i, j) = field.distance[j];
  }
  gram = functions.transpose() * (laplacian.mass.cast<float>().asDiagonal() * functions);
}

}  // namespace posture
