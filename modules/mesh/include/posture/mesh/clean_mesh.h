// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/types.h>

#include <vector>

namespace posture {

/// What cleaning found.
struct CleaningSummary {
  int unreferenced_vertices = 0;  ///< in no face
  int welded_vertices = 0;        ///< at the very place of an earlier one
  int degenerate_faces = 0;       ///< a corner twice, after welding
  int repeated_faces = 0;         ///< the corners of an earlier face
  int flipped_faces = 0;          ///< turned round, to agree with neighbours or outwards
  int non_manifold_edges = 0;     ///< with more than two faces
  int components = 0;             ///< connected parts of the surface
  int loose_vertices = 0;         ///< on parts other than the main surface
};

/// The main surface of a mesh - its connected part of largest area - and the way between its
/// vertices and those of the mesh as it was given.
struct CleanMesh {
  TriangleMesh mesh;              ///< connected; every vertex in a face; oriented where orientable
  std::vector<int> input_vertex;  ///< clean vertex -> the first input vertex at its place
  /// Input vertex -> clean vertex. A vertex off the main surface (a loose part, an unreferenced
  /// point) has the clean vertex nearest to it, which it follows. Never -1.
  std::vector<int> clean_vertex;
  /// Input vertex -> distance to that clean vertex; 0 exactly on the main surface.
  Vector offset;
  /// Whether an input vertex is on the main surface, and not only near it.
  bool isOnMain(Eigen::Index v) const { return offset[v] == 0; }
  std::vector<char> face_on_main;  ///< input face -> whether it is on the main surface
  /// Input face -> whether it must be turned round to look as the main surface or the piece it is
  /// in does; off these: whether the main surface was inside out.
  std::vector<char> face_turned;
  /// Whether the main surface, its largest patch, encloses a volume but for its holes, so that its
  /// own shape tells the outside.
  bool outward_known = false;
  /// Whether it looked the other way in nearly all its faces as it was given.
  bool inside_out = false;
  /// The other connected parts, those of less than a hundredth of its area left out; oriented each
  /// by itself, the way the main surface was turned where they do not tell.
  TriangleMesh pieces;
  std::vector<int> piece_vertex;  ///< vertex of the pieces -> the first input vertex at its place
  std::vector<int> piece_face;    ///< face of the pieces -> the input face it was
  CleaningSummary summary;
};

/// Which way the faces of a surface look in the end.
enum class Facing {
  OUTWARD,  ///< where it encloses a volume, but for holes with small lids; otherwise as most of it
  AS_MOST,  ///< of its area was given
};

/// Welds vertices at the same place, drops degenerate and repeated faces, orients faces alike,
/// keeps the main surface. Edges with more than two faces stay: geodesics run across them;
/// cutNonManifold() separates them where a stage needs it.
/// \throws InputError  no face is left, or none with an area; too large or too small to compute
/// with; std::invalid_argument  as requireMesh().
CleanMesh cleanMesh(const TriangleMesh& input, Facing facing = Facing::OUTWARD);

/// Turns the main surface the other way round, and pieces that do not tell their outside.
void turnOver(CleanMesh& clean);

/// The input's faces, turned as `clean.face_turned` says.
/// \throws std::invalid_argument  `clean` is of an input with more faces or fewer.
Faces facedAlike(const Faces& input, const CleanMesh& clean);

}  // namespace posture
