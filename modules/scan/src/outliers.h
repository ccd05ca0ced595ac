// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "neighbors.h"
#include <vector>

namespace posture {

/// Non-zero for points that belong to a part of the scan: their sixth neighbour is within four
/// spacings, and links of at most three spacings join them to a group of max(30, n / 500) points.
std::vector<char> withoutOutliers(const Points& points,
                                  const NeighborTable& neighbors,
                                  double spacing);

}  // namespace posture
