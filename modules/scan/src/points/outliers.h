// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "points/neighbors.h"
#include "points/spacing.h"
#include <vector>

namespace posture {

/// Non-zero for points that belong to a part of the scan: their sixth neighbour is within four
/// spacings, and links of at most three spacings join them to a group of max(30, n / 500) points.
/// Where the scan is sparse, spacings are those of the place, if the points lie on a surface there;
/// outliers among themselves do not.
std::vector<char> withoutOutliers(const Points& points,
                                  const NeighborTable& neighbors,
                                  const Spacing& spacing);

/// The same for points without noise, which may lie far apart on one part and close on another:
/// those whose third neighbour is within five spacings or that lie on a smooth surface with their
/// neighbours, and of the others what belongs to these, because four of the twelve nearest count it
/// among their own twelve nearest. To an outlier the surface is near, but it is not to the surface.
/// \pre  a table of twelve neighbours or more.
std::vector<char> withoutStrays(const Points& points,
                                const NeighborTable& neighbors,
                                const Spacing& spacing);

}  // namespace posture
