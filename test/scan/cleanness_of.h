// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "clean/cleanness.h"

namespace posture::test {

inline Cleanness cleannessOf(const Points& points) {
  const NeighborTable neighbors = NeighborSearch(points).table(24);
  return cleanness(points, neighbors, spacing(points, neighbors));
}

}  // namespace posture::test
