// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/types.h>

namespace posture {

/// m areas, in squared mesh units.
Vector faceAreas(const TriangleMesh& mesh);

/// The sum of these; 0 without faces.
double surfaceArea(const TriangleMesh& mesh);

/// Its square root: how large a shape is, however it bends.
double rootArea(const TriangleMesh& mesh);

/// How far apart the vertices of a surface are: the longest edge of a face, as the root mean square
/// over the surface, in square roots of its area. 0 where there is none.
double coarseness(const TriangleMesh& mesh);

}  // namespace posture
