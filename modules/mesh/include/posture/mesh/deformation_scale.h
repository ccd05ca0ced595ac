// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/types.h>

namespace posture {

/// The scale of a deformation: the median ratio of the edges' lengths between the places (one a
/// vertex) to those of the mesh. 1 where there are none.
double medianEdgeRatio(const TriangleMesh& mesh, const Points& places);

/// The same where noise makes edges longer: both shapes are smoothed alike before.
double scaleWithoutNoise(const TriangleMesh& mesh, const Points& places);

}  // namespace posture
