// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/types.h>

#include <vector>

namespace posture {

/// An undirected edge of a triangle mesh, first < second.
struct Edge {
  int first;
  int second;
  int faces;  ///< how many faces share it: 1 at a boundary, more than 2 where not manifold
};

/// All edges, sorted by (first, second).
std::vector<Edge> meshEdges(const Faces& faces);

/// The face beyond each side of each face (side k joins corners k and k + 1); -1 at a boundary and
/// where more than two faces meet.
Faces facesAcross(const Faces& faces);

double meanEdgeLength(const TriangleMesh& mesh);

/// n, non-zero for the ends of edges with a single face.
std::vector<char> boundaryVertices(const Faces& faces, int vertex_count);

}  // namespace posture
