// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/types.h>
#include <posture/mesh/vertex_neighbors.h>

#include <vector>

namespace posture {

/// The parts of a mesh that are joined by common vertices.
struct ConnectedParts {
  std::vector<int> of_face;  ///< m; parts are numbered by their first face
  std::vector<double> area;  ///< of each part
  int largest = -1;          ///< by area; -1 without faces
};

ConnectedParts connectedParts(const TriangleMesh& mesh);

/// For each vertex the least one that edges join it to; a vertex in no face is a part of its own.
std::vector<int> leastOfPart(const Faces& faces, int vertex_count);

/// The connected parts of the vertices marked, by their first vertices, each from there on.
/// \param neighbors  what joins two of them.
/// \param marked  n.
std::vector<std::vector<int>> markedParts(const VertexNeighbors& neighbors,
                                          std::vector<char> marked);

}  // namespace posture
