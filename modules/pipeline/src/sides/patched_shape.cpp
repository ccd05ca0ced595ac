// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sides/patched_shape.h"

#include <posture/mesh/bridge_pieces.h>
#include <posture/mesh/hole_patches.h>

#include "sides/pose.h"

namespace posture {
namespace {

/// Whether most faces of a surface look the other way after others were added behind them.
bool isTurnedRound(const CleanMesh& before, const CleanMesh& after) {
  int alike = 0;
  for (std::size_t f = 0; f < before.face_turned.size(); ++f)
    if (before.face_on_main[f] != 0 && after.face_on_main[f] != 0)
      alike += before.face_turned[f] == after.face_turned[f] ? 1 : -1;
  return alike < 0;
}

/// Cleans a side after surface was put in.
void cleanAgain(const CleanMesh& before, PatchedShape& patched) {
  patched.clean = cleanMesh(patched.input);
  // More may be known of its outside now than was before, and than is of the other side's.
  if (isTurnedRound(before, patched.clean)) turnOver(patched.clean);
}

}  // namespace

PatchedShape withPatches(const TriangleMesh& input, const CleanMesh& clean) {
  // In a frame and an order of its own, so that the patches do not depend on those it came in.
  const Pose pose = poseOf(clean.mesh);
  const CleanMesh ordered = inOrder(clean, pose);
  const HolePatches patches = patchHoles(posed(ordered.mesh, pose));
  PatchedShape patched{
      input, clean, static_cast<int>(patches.vertices.rows()), patches.holes, patches.rim_length};
  if (patches.holes == 0) return patched;
  const auto n = input.vertices.rows(), m = input.faces.rows();
  const auto of_clean = static_cast<int>(clean.mesh.vertices.rows());
  patched.input.vertices.conservativeResize(n + patches.vertices.rows(), 3);
  patched.input.vertices.bottomRows(patches.vertices.rows()) = pose.outOf(patches.vertices);
  patched.input.faces.conservativeResize(m + patches.faces.rows(), 3);
  for (Eigen::Index f = 0; f < patches.faces.rows(); ++f)
    for (int c = 0; c < 3; ++c) {
      const int v = patches.faces(f, c);
      patched.input.faces(m + f, c) =
          v < of_clean ? ordered.input_vertex[v] : static_cast<int>(n) + v - of_clean;
    }
  cleanAgain(clean, patched);
  return patched;
}

PatchedShape withPatches(const TriangleMesh& input, const PartedSurface& parted) {
  if (parted.contacts == 0) return withPatches(input, parted.clean);
  // The numbers of faces stay; a face of one corner is dropped in cleaning.
  TriangleMesh open = input;
  for (Eigen::Index f = 0; f < open.faces.rows(); ++f)
    if (parted.gone[f] != 0) open.faces.row(f).setConstant(open.faces(f, 0));
  PatchedShape patched = withPatches(open, parted.clean);
  patched.parted_contacts = parted.contacts;
  return patched;
}

PatchedShape withBridges(const TriangleMesh& input, const CleanMesh& clean) {
  PatchedShape joined{input, clean};
  if (clean.pieces.faces.rows() == 0) return joined;
  const Pose pose = poseOf(clean.mesh);
  const auto n = clean.mesh.vertices.rows(), m = input.faces.rows();
  const Bridges bridges =
      bridgePieces(withPieces(posed(clean.mesh, pose), posed(clean.pieces, pose)));
  joined.joined_pieces = bridges.pieces;
  if (bridges.pieces == 0) return joined;
  joined.input.faces.conservativeResize(m + bridges.faces.rows(), 3);
  for (Eigen::Index f = 0; f < bridges.faces.rows(); ++f)
    for (int c = 0; c < 3; ++c) {
      const int v = bridges.faces(f, c);
      joined.input.faces(m + f, c) =
          v < n ? clean.input_vertex[v] : clean.piece_vertex[v - static_cast<int>(n)];
    }
  cleanAgain(clean, joined);
  return joined;
}

}  // namespace posture
