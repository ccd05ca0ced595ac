// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "points/neighbors.h"
#include "points/oriented_points.h"
#include "points/spacing.h"

namespace posture {

/// Whether two normals belong to the same side of a part.
inline bool sameSheet(const Eigen::RowVector3d& a, const Eigen::RowVector3d& b) {
  return a.dot(b) > 0.2;
}

/// Keeps points at least half a spacing apart, of those on the same sheet, and no place farther
/// than that from one: points are taken in a random order unless one that was taken is too close.
OrientedPoints thin(const OrientedPoints& oriented,
                    const NeighborTable& neighbors,
                    const Spacing& spacing);

}  // namespace posture
