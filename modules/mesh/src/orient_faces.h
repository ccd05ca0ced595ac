// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/types.h>
#include <posture/mesh/clean_mesh.h>

#include <vector>

namespace posture {

struct Orientation {
  std::vector<char> turned;    ///< m, the faces turned round
  bool outward_known = false;  ///< for most of the area
};

/// Turns the faces of each patch, what is joined across edges of two faces, alike.
Orientation orientFaces(TriangleMesh& mesh, Facing facing);

}  // namespace posture
