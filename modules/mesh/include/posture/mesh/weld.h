// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/types.h>

#include <vector>

namespace posture {

/// Vertex -> the first vertex at the same place.
std::vector<int> weld(const Points& vertices);

/// Faces between these first vertices.
struct WeldedFaces {
  Faces faces;  ///< without those that have one twice or the corners of an earlier one
  std::vector<int> input_face;       ///< which each one was
  int degenerate = 0, repeated = 0;  ///< that were left out
};

WeldedFaces weldFaces(const Faces& faces, const std::vector<int>& first);

/// The same, where only the faces count.
Faces weldedFaces(const Faces& faces, const std::vector<int>& first);

}  // namespace posture
