// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "clean/circumspheres.h"
#include "points/orientation.h"
#include "points/spacing.h"

namespace posture {

/// Unit normals of points without noise, outward: towards the poles, the farthest centres of the
/// spheres at each point on either side (Amenta and Bern 1999). Which poles are of the inside is
/// found as in Kolluri, Shewchuk and O'Brien (2004): neighbours whose spheres overlap far are on
/// one side, the two poles of a point on opposite ones; here along a maximum spanning tree. Zero
/// for a point in no tetrahedron. Where nearly all are of one view each looks at the sensor.
Points poleNormals(const Points& points,
                   const Stars& stars,
                   const Circumspheres& spheres,
                   const Spacing& spacing,
                   const OutsideHints& hints,
                   OrientationSummary& summary);

}  // namespace posture
