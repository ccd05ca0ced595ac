// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/types.h>

#include <vector>

namespace posture {

/// Vertex -> the first vertex at the same place.
std::vector<int> weld(const Points& vertices);

/// Faces between these first vertices, without those that have one twice.
Faces weldedFaces(const Faces& faces, const std::vector<int>& first);

}  // namespace posture
