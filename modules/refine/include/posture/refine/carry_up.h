// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/deformation/reduce_mesh.h>
#include <posture/refine/bent_pair.h>

namespace posture {

/// What was found on reduced meshes, on the meshes they were reduced from: every vertex moves as
/// the reduced ones around it do, and takes the match of the nearest of them.
BentPair carryUp(const TriangleMesh& a,
                 const ReducedMesh& reduced_a,
                 const TriangleMesh& b,
                 const ReducedMesh& reduced_b,
                 const BentPair& pair);

}  // namespace posture
