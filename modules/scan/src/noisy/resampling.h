// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "points/neighbors.h"
#include <vector>

namespace posture {

/// How far the noise of a scan reaches.
struct NoiseScale {
  int neighbors = 10;         ///< how many it takes for the surface to look flat
  bool double_walls = false;  ///< it never does
};

/// The smallest of 10, 20, 40, .. 5120 neighbours whose root mean square distance from their plane
/// is below a fifth of their radius, in the median; 10 when there is none.
NoiseScale noiseScale(const Points& points, const NeighborSearch& search);

/// Non-empty cells of a cubic lattice: which points each has, and their mean.
struct Cells {
  Points means;           ///< c x 3
  std::vector<int> cell;  ///< n: the cell of each point
};

Cells averageInCells(const Points& points, double side);

}  // namespace posture
