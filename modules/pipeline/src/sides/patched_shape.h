// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sides/contacts.h"
#include "sides/given_shape.h"

namespace posture {

/// A side with surface put in where it was not seen: distances and spectra are then those of the
/// body, not of what was seen of it. The vertices and faces of the input come first, those of the
/// patches follow; a face cut out at a contact has its first corner three times.
struct PatchedShape {
  TriangleMesh input;
  CleanMesh clean;
  int patch_vertices = 0;
  int patched_holes = 0;
  double rim_length = 0;    ///< of the holes patched, over the square root of the area
  int joined_pieces = 0;    ///< to the main surface
  int parted_contacts = 0;  ///< cut open before holes were patched

  GivenShape given() const { return {input, clean, patch_vertices, patched_holes > 0}; }
};

/// With holes closed where the surface goes on across them (patchHoles()).
PatchedShape withPatches(const TriangleMesh& input, const CleanMesh& clean);

/// The same for a surface that is cut open where it seems grown together with itself.
PatchedShape withPatches(const TriangleMesh& input, const PartedSurface& parted);

/// With pieces joined to the main surface across narrow gaps (bridgePieces()).
PatchedShape withBridges(const TriangleMesh& input, const CleanMesh& clean);

}  // namespace posture
