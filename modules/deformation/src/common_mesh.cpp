// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/deformation/collapse.h>
#include <posture/deformation/common_mesh.h>
#include <posture/mesh/edges.h>

#include <limits>

namespace posture {
namespace {

/// Collapses one side to the paired vertices; faces are renumbered to the pairs.
Faces collapseToPairs(const TriangleMesh& mesh,
                      const std::vector<VertexPair>& pairs,
                      int VertexPair::*side) {
  std::vector<char> keep(mesh.vertices.rows(), 0);
  std::vector<int> pair_of(mesh.vertices.rows(), -1);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    keep[pairs[i].*side] = 1;
    pair_of[pairs[i].*side] = static_cast<int>(i);
  }
  Faces faces = collapseToVertices(mesh, keep);
  for (int i = 0; i < faces.size(); ++i) faces.data()[i] = pair_of[faces.data()[i]];
  return faces;
}

}  // namespace

CommonMeshes computeCommonMeshes(const TriangleMesh& source,
                                 const TriangleMesh& target,
                                 const std::vector<VertexPair>& pairs) {
  CommonMeshes meshes;
  CommonMesh& first = meshes.from_source;
  first.source.resize(pairs.size(), 3);
  first.target.resize(pairs.size(), 3);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    first.source.row(i) = source.vertices.row(pairs[i].source);
    first.target.row(i) = target.vertices.row(pairs[i].target);
  }
  meshes.from_target = first;
  meshes.from_source.faces = collapseToPairs(source, pairs, &VertexPair::source);
  meshes.from_target.faces = collapseToPairs(target, pairs, &VertexPair::target);
  return meshes;
}

double deformationEnergy(const CommonMesh& mesh) {
  const std::vector<Edge> edges = meshEdges(mesh.faces);
  if (edges.empty()) return std::numeric_limits<double>::infinity();
  double energy = 0;
  for (const Edge& e : edges) {
    const double change = (mesh.source.row(e.first) - mesh.source.row(e.second)).norm() -
                          (mesh.target.row(e.first) - mesh.target.row(e.second)).norm();
    energy += change * change;
  }
  return energy;
}

}  // namespace posture
