// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/types.h>

#include <vector>

namespace posture {

/// What of a mesh was taken for a floor, a table or a wall that its body was scanned on or before.
struct Background {
  int faces = 0;
  /// n, non-zero for one in such faces alone, unless what is in others is at its place; or empty:
  /// none is
  std::vector<char> vertices;
  int left_over = 0;  ///< in such faces alone, but not marked: they are in no face any more
};

/// Leaves backgroundFaces() out of a mesh: all corners of such a face become one, so that cleaning
/// drops it and the other faces keep their numbers.
Background leaveOutBackground(TriangleMesh& mesh);

}  // namespace posture
