// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/types.h>

namespace posture::test {

/// A fin of three faces on one edge, a bow-tie at vertex 3, faces against each other, vertex 8 in
/// none.
inline Faces strangeFaces() {
  Faces faces(5, 3);
  faces << 0, 1, 2, 0, 1, 3, 1, 0, 4, 3, 5, 6, 5, 6, 7;
  return faces;
}

}  // namespace posture::test
