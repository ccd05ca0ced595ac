// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/types.h>

#include <vector>

namespace posture {

/// The faces of what a body was scanned on or before: a floor, a table, a wall, joined to it or
/// not. Such a plane goes on around the body and past it, and what is not in a plane is on one
/// side of it; flat parts of a body have the rest of it over them, or at their edge.
///
/// \return  m, non-zero for a face in such a plane or beyond it; all zero where there is none.
/// \throws std::invalid_argument  as requireMesh().
std::vector<char> backgroundFaces(const TriangleMesh& mesh);

}  // namespace posture
