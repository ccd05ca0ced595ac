// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sides/given_shape.h"

#include <posture/core/error.h>
#include <posture/deformation/follow_matches.h>
#include <posture/geodesic/fast_marching.h>
#include <posture/mesh/areas.h>
#include <posture/mesh/edges.h>
#include <posture/mesh/normals.h>
#include <posture/mesh/weld.h>

namespace posture {

Points inputNormals(const GivenShape& shape) {
  const std::vector<int> first = weld(shape.input.vertices);
  const Faces faces = weldedFaces(facedAlike(shape.input.faces, shape.clean), first);
  return vertexNormals({shape.input.vertices, faces})(first, Eigen::all);
}

std::vector<char> inputRim(const GivenShape& shape) {
  const std::vector<int> first = weld(shape.input.vertices);
  const std::vector<char> rim =
      boundaryVertices(weldedFaces(shape.input.faces, first), static_cast<int>(first.size()));
  std::vector<char> on_rim;
  on_rim.reserve(first.size());
  for (int v : first) on_rim.push_back(rim[v]);
  return on_rim;
}

ShapeSummary summarize(const GivenShape& shape) {
  ShapeSummary summary;
  summary.vertices = static_cast<int>(shape.input.vertices.rows());
  summary.faces = static_cast<int>(shape.input.faces.rows());
  summary.cleaning = shape.clean.summary;
  summary.clean_vertices = static_cast<int>(shape.clean.mesh.vertices.rows());
  for (const Edge& e : meshEdges(shape.clean.mesh.faces)) summary.boundary_edges += e.faces == 1;
  summary.area = surfaceArea(shape.clean.mesh);
  summary.mean_edge_length = meanEdgeLength(shape.clean.mesh);
  return summary;
}

Landmarks sampleSide(const std::string& side, const TriangleMesh& mesh, int most) {
  Landmarks landmarks = computeLandmarks(mesh, FastMarching(mesh), most);
  // The affine part of a spline takes four, three axes of distances as many.
  if (landmarks.vertices.size() < 5)
    throw InputError(side + " has only " + std::to_string(landmarks.vertices.size()) +
                     " places an edge's length from each other: too few to tell a shape");
  return landmarks;
}

TriangleMesh withPieces(TriangleMesh surface, const TriangleMesh& pieces) {
  const auto n = surface.vertices.rows(), m = surface.faces.rows();
  surface.vertices.conservativeResize(n + pieces.vertices.rows(), 3);
  surface.vertices.bottomRows(pieces.vertices.rows()) = pieces.vertices;
  surface.faces.conservativeResize(m + pieces.faces.rows(), 3);
  surface.faces.bottomRows(pieces.faces.rows()) = pieces.faces.array() + static_cast<int>(n);
  return surface;
}

std::vector<int> toInput(const std::vector<int>& map,
                         const CleanMesh& source,
                         const CleanMesh& target) {
  std::vector<int> target_vertex(source.clean_vertex.size(), -1);
  for (std::size_t v = 0; v < target_vertex.size(); ++v) {
    const int t = map[source.clean_vertex[v]];
    if (t >= 0) target_vertex[v] = target.input_vertex[t];
  }
  return target_vertex;
}

Points placesOfInput(const GivenShape& source,
                     const TriangleMesh& mesh,
                     const std::vector<char>& known,
                     const Points& places,
                     const Points& input) {
  std::vector<int> loose, anchor;
  for (int v = 0; v < source.input.vertices.rows(); ++v)
    if (!source.clean.isOnMain(v)) {
      loose.push_back(v);
      anchor.push_back(source.clean.clean_vertex[v]);
    }
  Points extra(loose.size(), 3);
  for (std::size_t i = 0; i < loose.size(); ++i) extra.row(i) = input.row(loose[i]);
  const Points moved = followMatches(mesh, known, places, extra, anchor);

  Points of_input(source.input.vertices.rows(), 3);
  for (int v = 0; v < of_input.rows(); ++v)
    of_input.row(v) = moved.row(source.clean.clean_vertex[v]);
  for (std::size_t i = 0; i < loose.size(); ++i)
    of_input.row(loose[i]) = moved.row(mesh.vertices.rows() + i);
  return of_input;
}

}  // namespace posture
