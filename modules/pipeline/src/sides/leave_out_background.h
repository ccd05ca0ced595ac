// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/types.h>

#include <vector>

namespace posture {

/// What of a mesh was taken for a floor, a table or a wall that its body was scanned on or before.
struct Background {
  int faces = 0;
  /// n, non-zero for a vertex that is in its faces alone and not at the place of one of the body's;
  /// empty: no background.
  std::vector<char> vertices;
  int left_over = 0;  ///< vertices in its faces alone, but at the place of one of the body's
};

/// Leaves backgroundFaces() out of a mesh: all corners of such a face become one, so that cleaning
/// drops it and the other faces keep their numbers.
Background leaveOutBackground(TriangleMesh& mesh);

}  // namespace posture
