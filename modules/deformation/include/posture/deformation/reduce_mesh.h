// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/types.h>

#include <vector>

namespace posture {

/// A mesh on fewer of its vertices.
struct ReducedMesh {
  TriangleMesh mesh;         ///< connected; every vertex in a face
  std::vector<int> vertex;   ///< reduced vertex -> vertex of the mesh given; the farthest-point
                             ///< order, so that any prefix is spread evenly too
  std::vector<int> nearest;  ///< vertex of the mesh given -> reduced vertex near it, along the
                             ///< surface wherever that has one
};

/// Reduces a connected mesh to about `count` of its vertices, spread evenly: farthest-point samples
/// are kept, the others collapsed (collapseToVertices), and edges then flipped towards a Delaunay
/// triangulation, as the Laplacian asks for. A mesh of at most `count` vertices keeps its faces.
/// \throws InputError  no face is left: edges with more than two faces are not collapsed.
ReducedMesh reduceMesh(const TriangleMesh& mesh, int count);

/// Flips edges whose opposite angles sum to more than pi, except where a face would come to lie
/// more than 60 degrees from the two before. Sharp edges between thin faces may be cut off.
Faces delaunayFlips(const TriangleMesh& mesh);

}  // namespace posture
