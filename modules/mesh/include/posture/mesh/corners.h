// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/types.h>

#include <vector>

namespace posture {

/// Non-zero for the corners of faces between three different vertices.
std::vector<char> cornersOfFaces(const Faces& faces, int vertex_count);

/// For each vertex a face it is a corner of; -1 for a vertex in no face.
std::vector<int> faceOfEachVertex(const Faces& faces, int vertex_count);

/// How many different places the corners of faces with three different ones lie at, of the first
/// `vertices` vertices; vertices at one place count once.
int cornerPlaces(const TriangleMesh& mesh, int vertices);

}  // namespace posture
