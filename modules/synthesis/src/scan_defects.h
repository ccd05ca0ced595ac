// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/rng.h>
#include <posture/core/types.h>

#include <vector>

namespace posture::synthesis {

struct PunchedMesh {
  Faces faces;                ///< numbered anew
  std::vector<int> survivor;  ///< the vertices that are left, by their old number
};

/// Cuts discs of the given geodesic radius (at least one triangle) out of a closed mesh, well
/// apart. What is left is one manifold piece of genus 0 with exactly `holes` boundary loops.
/// \throws std::invalid_argument  so many do not fit.
PunchedMesh punchHoles(const TriangleMesh& mesh, int holes, double radius, Rng& rng);

/// Moves each vertex along its normal by a normally distributed way.
void addNoise(TriangleMesh& mesh, double deviation, Rng& rng);

}  // namespace posture::synthesis
