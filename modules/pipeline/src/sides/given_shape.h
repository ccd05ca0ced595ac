// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/correspondence.h>
#include <posture/geodesic/landmarks.h>
#include <posture/mesh/clean_mesh.h>
#include <posture/pipeline/register_shapes.h>

#include <string>
#include <vector>

namespace posture {

/// One side as it came, and its main surface.
struct GivenShape {
  const TriangleMesh& input;
  const CleanMesh& clean;
  int patch_vertices = 0;   ///< the last so many of the input belong to patches
  bool is_patched = false;  ///< holes were closed; those of three edges by a face alone

  int ownVertices() const { return static_cast<int>(input.vertices.rows()) - patch_vertices; }

  /// Whether a vertex of the main surface belongs to a patch; those added to it do not.
  bool isPatch(int clean_vertex) const {
    return clean_vertex < static_cast<int>(clean.input_vertex.size()) &&
           clean.input_vertex[clean_vertex] >= ownVertices();
  }
};

/// Normals of all vertices of the input, the way the main surface looks, however it was given; 0 of
/// a vertex in no face. Vertices at one place have one.
Points inputNormals(const GivenShape& shape);

/// Whether each vertex of the input lies at a rim, with vertices at one place joined.
std::vector<char> inputRim(const GivenShape& shape);

/// What cleaning tells of a side; samples and stress are left to the method.
ShapeSummary summarize(const GivenShape& shape);

/// Voronoi samples of a main surface with distances and confidences.
/// \throws InputError  too few to tell a shape; names the side.
Landmarks sampleSide(const std::string& side, const TriangleMesh& mesh, int most = 1000);

/// A main surface and its pieces as one mesh, the vertices and faces of the surface first.
TriangleMesh withPieces(TriangleMesh surface, const TriangleMesh& pieces);

/// A map between clean vertices in the numbering of the input; loose vertices go where the vertex
/// they follow goes. -1 stays -1.
std::vector<int> toInput(const std::vector<int>& map,
                         const CleanMesh& source,
                         const CleanMesh& target);

/// Places of all source vertices as given, from those of the clean ones: loose parts make the
/// motion of the surface around the vertex they follow.
/// \param known, places  of the clean vertices, as for followMatches.
/// \param mesh  the clean source in the unit of the places.
/// \param input  all source vertices, in the frame of `mesh`.
Points placesOfInput(const GivenShape& source,
                     const TriangleMesh& mesh,
                     const std::vector<char>& known,
                     const Points& places,
                     const Points& input);

}  // namespace posture
