// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/compact_vertices.h>
#include <posture/core/computable.h>
#include <posture/core/error.h>
#include <posture/mesh/clean_mesh.h>
#include <posture/mesh/connected_parts.h>
#include <posture/mesh/edges.h>
#include <posture/mesh/point_index.h>
#include <posture/mesh/require_mesh.h>
#include <posture/mesh/weld.h>

#include "orient_faces.h"
#include <algorithm>
#include <limits>
#include <utility>

namespace posture {
namespace {

/// Of the main surface's area: less is a crumb.
constexpr double LEAST_PIECE = 0.01;

/// Orients the pieces, each by itself, and notes whose faces were turned for it.
/// \param given  as `clean.face_turned` says so far.
void turnPieces(const Faces& given, CleanMesh& clean) {
  orientPieces(clean.pieces);
  for (std::size_t f = 0; f < clean.piece_face.size(); ++f) {
    const auto row = static_cast<Eigen::Index>(f);
    if (clean.pieces.faces.row(row) != given.row(row)) {
      char& turned = clean.face_turned[clean.piece_face[f]];
      turned = static_cast<char>(turned == 0);
    }
  }
}

/// Puts the parts other than the main one that are no crumbs into `clean.pieces`.
void keepPieces(const TriangleMesh& welded,
                const std::vector<int>& input_face,
                const ConnectedParts& parts,
                CleanMesh& clean) {
  std::vector<int> kept;
  for (int f = 0; f < welded.faces.rows(); ++f) {
    const int part = parts.of_face[f];
    if (part == parts.largest || parts.area[part] < LEAST_PIECE * parts.area[parts.largest])
      continue;
    kept.push_back(f);
    clean.piece_face.push_back(input_face[f]);
  }
  clean.pieces.faces = welded.faces(kept, Eigen::all);
  clean.piece_vertex =
      compactVerticesByUse(clean.pieces.faces, static_cast<int>(welded.vertices.rows()));
  clean.pieces.vertices = welded.vertices(clean.piece_vertex, Eigen::all);
  if (clean.inside_out) clean.pieces.faces.col(1).swap(clean.pieces.faces.col(2));
  turnPieces(Faces(clean.pieces.faces), clean);
}

/// Not norm(), whose squares may vanish.
double extentOf(const Points& vertices) {
  return (vertices.colwise().maxCoeff() - vertices.colwise().minCoeff()).maxCoeff();
}

/// What rounding leaves between corners in a line, as read or far from the origin.
double areaOfRounding(const Points& vertices) {
  const double extent = (vertices.colwise().maxCoeff() - vertices.colwise().minCoeff()).norm();
  const double digit = std::numeric_limits<double>::epsilon() * vertices.cwiseAbs().maxCoeff();
  return extent * std::max(1e-12 * extent, 4 * digit);
}

/// Input vertices that are no corner of the main surface follow the clean vertex nearest to them.
void attachLooseVertices(const Points& vertices, CleanMesh& clean) {
  const bool any_loose = std::count(clean.clean_vertex.begin(), clean.clean_vertex.end(), -1) > 0;
  if (!any_loose) return;
  const PointIndex index(clean.mesh.vertices);
  for (int v = 0; v < vertices.rows(); ++v) {
    if (clean.clean_vertex[v] >= 0) continue;
    const int nearest = index.nearest(vertices.row(v)).index;
    clean.clean_vertex[v] = nearest;
    // Not the distance of the index, in whose single precision it may be 0.
    clean.offset[v] = (vertices.row(v) - clean.mesh.vertices.row(nearest)).norm();
  }
}

/// The corners of the largest part, numbered in the order of the input, and its faces.
/// \return  which of the welded faces these were.
std::vector<int> keepLargest(const TriangleMesh& welded,
                             const ConnectedParts& parts,
                             CleanMesh& clean) {
  const int n = static_cast<int>(welded.vertices.rows());
  std::vector<int> kept;
  for (int f = 0; f < welded.faces.rows(); ++f)
    if (parts.of_face[f] == parts.largest) kept.push_back(f);
  clean.mesh.faces = welded.faces(kept, Eigen::all);
  clean.input_vertex = compactVertices(clean.mesh.faces, n);
  clean.mesh.vertices = welded.vertices(clean.input_vertex, Eigen::all);
  clean.clean_vertex.assign(n, -1);
  for (std::size_t i = 0; i < clean.input_vertex.size(); ++i)
    clean.clean_vertex[clean.input_vertex[i]] = static_cast<int>(i);
  return kept;
}

/// Faces alike, and notes which of the input's were turned for it.
/// \param input_face  of each face of the main surface.
void faceAlike(const Faces& input,
               const std::vector<int>& input_face,
               Facing facing,
               CleanMesh& clean) {
  const Orientation orientation = orientFaces(clean.mesh, facing);
  clean.outward_known = orientation.outward_known;
  clean.inside_out = orientation.inside_out;
  clean.face_on_main.assign(input.rows(), 0);
  clean.face_turned.assign(input.rows(), clean.inside_out ? 1 : 0);
  for (std::size_t f = 0; f < input_face.size(); ++f) {
    clean.face_on_main[input_face[f]] = 1;
    clean.face_turned[input_face[f]] = orientation.turned[f];
    clean.summary.flipped_faces += orientation.turned[f];
  }
}

}  // namespace

CleanMesh cleanMesh(const TriangleMesh& input, Facing facing) {
  const int n = static_cast<int>(input.vertices.rows());
  if (input.faces.rows() == 0) throw InputError("has no faces");
  requireMesh(input);
  requireNotTooLarge(input.vertices.cwiseAbs().maxCoeff());
  CleanMesh clean;
  CleaningSummary& summary = clean.summary;
  const std::vector<int> representative = weld(input.vertices);
  for (int v = 0; v < n; ++v) summary.welded_vertices += representative[v] != v;

  const WeldedFaces usable = weldFaces(input.faces, representative);
  summary.degenerate_faces = usable.degenerate;
  summary.repeated_faces = usable.repeated;
  const TriangleMesh welded{input.vertices, usable.faces};
  if (welded.faces.rows() == 0) throw InputError("has no face with three different corners");
  const ConnectedParts parts = connectedParts(welded);
  summary.components = static_cast<int>(parts.area.size());
  const std::vector<int> kept = keepLargest(welded, parts, clean);
  for (int v = 0; v < n; ++v) clean.clean_vertex[v] = clean.clean_vertex[representative[v]];

  std::vector<char> referenced(n, 0);
  for (int v : input.faces.reshaped()) referenced[v] = 1;
  for (int v = 0; v < n; ++v) {
    summary.unreferenced_vertices += referenced[v] == 0;
    summary.loose_vertices += referenced[v] != 0 && clean.clean_vertex[v] < 0;
  }

  requireSurfaceExtent(extentOf(clean.mesh.vertices));
  if (!(parts.area[parts.largest] > areaOfRounding(clean.mesh.vertices)))
    throw InputError("has only faces without area");
  clean.offset = Vector::Zero(n);
  std::vector<int> input_face;
  input_face.reserve(kept.size());
  for (int f : kept) input_face.push_back(usable.input_face[f]);
  faceAlike(input.faces, input_face, facing, clean);
  for (const Edge& e : meshEdges(clean.mesh.faces)) summary.non_manifold_edges += e.faces > 2;
  attachLooseVertices(input.vertices, clean);
  keepPieces(welded, usable.input_face, parts, clean);
  return clean;
}

void turnOver(CleanMesh& clean) {
  for (TriangleMesh* mesh : {&clean.mesh, &clean.pieces})
    mesh->faces.col(1).swap(mesh->faces.col(2));
  for (char& turned : clean.face_turned) turned = static_cast<char>(turned == 0);
  turnPieces(Faces(clean.pieces.faces), clean);
  clean.inside_out = !clean.inside_out;
  clean.summary.flipped_faces =
      static_cast<int>(clean.mesh.faces.rows()) - clean.summary.flipped_faces;
}

Faces facedAlike(const Faces& input, const CleanMesh& clean) {
  require(clean.face_turned.size() == static_cast<std::size_t>(input.rows()),
          "facedAlike: cleaned of another input");
  Faces faces = input;
  for (Eigen::Index f = 0; f < faces.rows(); ++f)
    if (clean.face_turned[f] != 0) std::swap(faces(f, 1), faces(f, 2));
  return faces;
}

}  // namespace posture
