// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/scan/reconstruct.h>

#include "smoothing.h"
#include <vector>

namespace posture {

/// Lays a surface through the samples: manifold, oriented, holes open, small pieces left out.
/// Lengths in the summary are in the working frame.
/// \throws InputError  no surface is found.
TriangleMesh meshSamples(const OrientedPoints& samples,
                         SurfaceMethod method,
                         ReconstructionSummary& summary);

/// Manifold, without small pieces and pin-holes. `kept` has the vertex each new one was; `dropped`
/// counts the pieces. \pre  no edge runs twice in one direction.
TriangleMesh repaired(TriangleMesh mesh, double spacing, std::vector<int>& kept, int& dropped);

/// Fills in what the summary says of the mesh, but for contacts.
void describe(const TriangleMesh& mesh, double spacing, ReconstructionSummary& summary);

}  // namespace posture
