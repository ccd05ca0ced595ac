// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/types.h>

namespace posture {

/// Vertices at rims go to the first one there that is nearer than a hundredth of the shortest edge
/// at both, and of the median edge at rims: files that list the corners of each face may have
/// rounded them in several ways.
/// \returns how many vertices went elsewhere. \pre  a mesh as requireMesh() asks for.
int closeSeams(TriangleMesh& mesh);

}  // namespace posture
