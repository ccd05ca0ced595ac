// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/types.h>

#include <vector>

namespace posture {

/// Vertex -> the first vertex at the same place; at rims also the first one that is as near as
/// rounding leaves what was one, as in files that list the corners of each face.
std::vector<int> weld(const TriangleMesh& mesh);

/// Faces between these first vertices, without those that have one twice.
Faces weldedFaces(const Faces& faces, const std::vector<int>& first);

}  // namespace posture
