// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/types.h>

namespace posture {

/// Surface for the holes of a mesh.
struct HolePatches {
  Points vertices;        ///< new ones, numbered after those of the mesh
  Faces faces;            ///< oriented as those of the mesh
  int holes = 0;          ///< that got a patch
  double rim_length = 0;  ///< of these, in all
};

/// Patches for the holes that may be closed: those with a rim shorter than half the square root of
/// the area, across which the way is never more than half the rim shorter than around, and those
/// the surface goes on across, where a soap film in the rim is, on the mean, less than 75 degrees
/// away from it. Long gaps between parts that lie side by side and the borders of sheets stay open.
/// Patches go on smoothly from the surface (least squared umbrellas, Kobbelt et al. 1998; the film
/// itself where that overshoots) and are about as fine as the rim. They have no more vertices
/// than the mesh: what goes beyond that stays open.
/// \param mesh  oriented; edges of more than two faces, or of faces that disagree, are no holes.
HolePatches patchHoles(const TriangleMesh& mesh);

}  // namespace posture
