// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/point_cloud.h>

#include "points/orientation.h"
#include <vector>

namespace posture {

/// What the cloud tells of the outside at some of its points, the surest of what there is: the
/// sensor, the grid of a depth image, normals.
OutsideHints outsideHints(const PointCloud& cloud, const std::vector<int>& rows);

}  // namespace posture
