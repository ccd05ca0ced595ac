// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/scan/reconstruct.h>

#include "points/oriented_points.h"

namespace posture {

/// Lays a surface through the samples: manifold, oriented, holes open, small pieces left out.
/// Lengths in the summary are in the working frame.
/// \throws InputError  no surface is found.
TriangleMesh meshSamples(const OrientedPoints& samples,
                         SurfaceMethod method,
                         ReconstructionSummary& summary);

}  // namespace posture
