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

/// The scale of a deformation: the median ratio of the edges' lengths between the places (one a
/// vertex) to those of the mesh. 1 where there are none.
double medianEdgeRatio(const TriangleMesh& mesh, const Points& places);

/// The same where noise makes edges longer: both shapes are smoothed alike before.
double scaleWithoutNoise(const TriangleMesh& mesh, const Points& places);

/// m areas, in squared mesh units.
Vector faceAreas(const TriangleMesh& mesh);

/// The sum of these; 0 without faces.
double surfaceArea(const TriangleMesh& mesh);

/// Its square root: how large a shape is, however it bends.
double rootArea(const TriangleMesh& mesh);

/// Non-zero for the corners of faces between three different vertices.
std::vector<char> cornersOfFaces(const Faces& faces, int vertex_count);

/// For each vertex a face it is a corner of; -1 for a vertex in no face.
std::vector<int> faceOfEachVertex(const Faces& faces, int vertex_count);

}  // namespace posture
