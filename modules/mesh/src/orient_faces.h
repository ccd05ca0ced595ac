// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/types.h>
#include <posture/mesh/clean_mesh.h>

#include <vector>

namespace posture {

struct Orientation {
  std::vector<char> turned;    ///< m, the faces turned round
  bool outward_known = false;  ///< of the largest patch, by its volume
  bool inside_out = false;     ///< it was given so, nearly all of it
};

/// Turns the faces of each patch, what is joined across edges of two faces, alike. Where the
/// largest one is inside out, so are others that are open.
Orientation orientFaces(TriangleMesh& mesh, Facing facing);

/// The same of patches that have nothing to do with each other: closed ones look outwards, others
/// as most of their area was given.
void orientPieces(TriangleMesh& pieces);

}  // namespace posture
