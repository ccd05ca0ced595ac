// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/types.h>

#include <vector>

namespace posture {

/// Keeps of each vertex its largest fan of faces, until every vertex has one.
/// \pre  no edge runs twice in one direction.
Faces largestFans(const Faces& faces, int vertex_count);

/// Closed walks along the boundary, against the faces beside it: a hole's own faces run this way.
/// \pre  manifold and oriented.
std::vector<std::vector<int>> boundaryLoops(const Faces& faces, int vertex_count);

/// Closes boundary loops no longer than `perimeter`, cutting off the ear of shortest diagonal each
/// time; no edge is used twice.
Faces closePinHoles(const TriangleMesh& mesh, double perimeter);

/// Leaves out connected pieces of less than `least` faces; `dropped` counts them.
Faces withoutSmallPieces(const Faces& faces, int vertex_count, int least, int& dropped);

/// Leaves out vertices in no face. `kept` has the vertex each new one was.
TriangleMesh withoutLooseVertices(const TriangleMesh& mesh, std::vector<int>& kept);

}  // namespace posture
