// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/types.h>

namespace posture {

/// Faces that join the pieces of a surface.
struct Bridges {
  Faces faces;     ///< of vertices of the mesh; oriented as the faces they join
  int pieces = 0;  ///< that were joined to the largest one, one by way of another too
};

/// Strips of faces across narrow gaps between the connected parts of a surface, as scans have them
/// where a fold or a limb before it hid what joins them: to the part of largest area the others are
/// joined, the nearest first, as long as the gap is at most a twentieth of the square root of the
/// area. No edge gets more than two faces; parts without a rim stay by themselves. The result does
/// not depend on the order of vertices and faces.
/// \param mesh  oriented, at least within each part.
Bridges bridgePieces(const TriangleMesh& mesh);

}  // namespace posture
