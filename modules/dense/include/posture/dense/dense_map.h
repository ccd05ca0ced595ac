// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/correspondence.h>
#include <posture/core/types.h>
#include <posture/embedding/canonical_form.h>
#include <posture/geodesic/landmarks.h>
#include <posture/matching/candidates.h>

#include <vector>

namespace posture {

/// A counterpart for each source vertex.
struct DenseMap {
  std::vector<int> target_vertex;  ///< n; -1: rejected
  Vector confidence;               ///< n, in [0, 1]; 0 where rejected
};

/// One side of a registration: what the stages up to the canonical form know of it.
struct EmbeddedShape {
  TriangleMesh mesh;
  Landmarks landmarks;
  CanonicalForm form;
};

/// The dense map of section 4.2 for the matches of one candidate that the kernel kept: a thin-plate
/// spline takes the source's canonical form over the target's, each vertex goes to the target
/// vertex nearest there, and is accepted when it is consistent with the matches under
/// `threshold` (c0).
DenseMap computeDenseMap(const EmbeddedShape& source,
                         const EmbeddedShape& target,
                         const Candidate& candidate,
                         const std::vector<int>& kernel,
                         double threshold);

/// The accepted pairs, each target vertex once, in their order: of the source vertices that share
/// one, the one of most confidence. What common meshes are made of (section 5).
std::vector<VertexPair> oneToOne(const DenseMap& map, int target_count);

}  // namespace posture
