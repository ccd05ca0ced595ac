// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/error.h>
#include <posture/mesh/edges.h>
#include <posture/mesh/normals.h>
#include <posture/refine/surface.h>

#include <utility>

namespace posture {

BendableSurface::BendableSurface(TriangleMesh surface)
    : mesh(std::move(surface)),
      normals(vertexNormals(mesh)),
      neighbors(mesh.faces, static_cast<int>(mesh.vertices.rows())),
      within_two_edges(neighbors.withinTwoEdges()),
      faces_around(mesh.faces, static_cast<int>(mesh.vertices.rows())),
      on_boundary(boundaryVertices(mesh.faces, static_cast<int>(mesh.vertices.rows()))),
      laplacian(cotangentLaplacian(mesh)),
      arap(mesh, laplacian) {}

double areaShare(const BendableSurface& surface, const std::vector<char>& marked) {
  const Vector& mass = surface.laplacian.mass;
  double sum = 0;
  for (std::size_t v = 0; v < marked.size(); ++v)
    if (marked[v]) sum += mass[static_cast<Eigen::Index>(v)];
  return sum / mass.sum();
}

SpectralSurface::SpectralSurface(TriangleMesh surface, const Matrix& basis, Vector values)
    : BendableSurface(std::move(surface)),
      functions(basis.cast<float>()),
      eigenvalues(std::move(values)),
      distances(mesh) {
  require(functions.rows() == mesh.vertices.rows() && functions.cols() == eigenvalues.size(),
          "SpectralSurface: one row a vertex, one eigenvalue a function");
  gram = functions.transpose() * (laplacian.mass.cast<float>().asDiagonal() * functions);
}

}  // namespace posture
