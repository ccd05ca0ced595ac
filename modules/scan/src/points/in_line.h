// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "points/neighbors.h"

namespace posture {

/// Whether a point and its 16 nearest neighbours are in a line: they tell no normal.
bool isInLine(const Points& points, const NeighborTable& neighbors, int i);

}  // namespace posture
