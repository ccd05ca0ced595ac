// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/scan/reconstruct.h>

#include <vector>

namespace posture {

/// Manifold, without small pieces and pin-holes. `kept` has the vertex each new one was; `dropped`
/// counts the pieces. \pre  no edge runs twice in one direction.
TriangleMesh repaired(TriangleMesh mesh, double spacing, std::vector<int>& kept, int& dropped);

/// Fills in what the summary says of the mesh, but for contacts.
void describe(const TriangleMesh& mesh, double spacing, ReconstructionSummary& summary);

}  // namespace posture
