// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/mesh/clean_mesh.h>

#include <vector>

namespace posture {

/// A main surface cut open where it seems grown together with itself: a hand on a hip that scanning
/// made one surface, which shortens every path that may go there.
struct PartedSurface {
  CleanMesh clean;         ///< of the same input; without the faces along the contacts
  int contacts = 0;        ///< cut; 0: nothing seems grown together
  std::vector<char> gone;  ///< face of the input -> whether it is along a contact
};

/// The main surfaces of both sides.
struct PartedSides {
  PartedSurface source, target;

  bool any() const { return source.contacts + target.contacts > 0; }
};

/// Contacts are looked for where the surface has a handle with a long way around: the narrowest
/// ring of edges that opens it leads to where it folds inwards (contactSeam()). Whether scanning
/// made the handle or the body has it is for the maps to tell. Ten handles are opened at most; a
/// cut that would leave no surface is not made.
PartedSurface partedSurface(const TriangleMesh& input, const CleanMesh& clean);

}  // namespace posture
