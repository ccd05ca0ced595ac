// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "noisy/tangent_delaunay.h"
#include "points/oriented_points.h"

namespace posture {

/// Candidates that go together, those of three votes first, then small ones: no edge is used twice
/// in a direction, no two triangles fold over at an edge or overlap around a corner.
Faces agreeingFaces(const OrientedPoints& oriented, std::vector<TangentTriangle> candidates);

}  // namespace posture
