// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "surface/finished_surface.h"

#include <posture/mesh/connected_parts.h>

#include "surface/doubts.h"
#include "surface/repair.h"
#include <cstddef>

namespace posture {
namespace {

constexpr int FEWEST_FACES = 50;  ///< of a piece

}  // namespace

TriangleMesh repaired(TriangleMesh mesh, double spacing, std::vector<int>& kept, int& dropped) {
  const int n = static_cast<int>(mesh.vertices.rows());
  mesh.faces = largestFans(mesh.faces, n);
  mesh.faces = withoutSmallPieces(mesh.faces, n, FEWEST_FACES, dropped);
  mesh.faces = closePinHoles(mesh, 12 * spacing);
  mesh.faces = largestFans(mesh.faces, n);
  return withoutLooseVertices(mesh, kept);
}

void describe(const TriangleMesh& mesh, double spacing, ReconstructionSummary& summary) {
  const int n = static_cast<int>(mesh.vertices.rows());
  summary.vertices = n;
  summary.faces = static_cast<int>(mesh.faces.rows());
  summary.components = static_cast<int>(connectedParts(mesh).area.size());
  for (const std::vector<int>& loop : boundaryLoops(mesh.faces, n)) {
    ++summary.boundary_loops;
    for (std::size_t k = 0; k < loop.size(); ++k)
      summary.boundary_length +=
          (mesh.vertices.row(loop[k]) - mesh.vertices.row(loop[(k + 1) % loop.size()])).norm();
  }
  summary.thin = thinShare(mesh, spacing);
}

}  // namespace posture
