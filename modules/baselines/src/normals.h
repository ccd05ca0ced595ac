// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "working_frame.h"

namespace posture {

/// Neighbours whose plane gives a normal: in PCL's tutorial on pairwise registration.
constexpr int NORMAL_NEIGHBORS = 30;

/// The cloud with the normals it has, or with PCL's. Those are turned to the sensor where it is
/// known, else away from the middle of the points, as a body shows its outside to its scanners.
LocalCloud withNormals(const LocalCloud& cloud);

/// Likewise, from the points of `surface` within a radius.
LocalCloud withNormals(const LocalCloud& cloud, const Points& surface, double radius);

}  // namespace posture
