// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/types.h>

namespace posture {

/// n x 3 unit normals of the vertices, faces weighted by their area; zero for a vertex in no face.
Points vertexNormals(const TriangleMesh& mesh);

}  // namespace posture
