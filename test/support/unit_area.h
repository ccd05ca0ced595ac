// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/mesh/areas.h>

namespace posture::test {

/// The mesh scaled to an area of one.
inline TriangleMesh unitArea(TriangleMesh mesh) {
  mesh.vertices /= rootArea(mesh);
  return mesh;
}

}  // namespace posture::test
