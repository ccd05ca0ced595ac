// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/types.h>

namespace posture {

/// Turns edges while that lowers the total absolute mean curvature, the sum over the edges of
/// length times angle between the faces (Dyn et al., Optimizing 3D triangulations using discrete
/// curvature analysis, 2001): where points lie far apart along a limb and close around it, edges
/// then run along it. \pre  manifold and oriented.
Faces withLessCurvature(const TriangleMesh& mesh);

}  // namespace posture
