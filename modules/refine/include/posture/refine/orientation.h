// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/types.h>
#include <posture/deformation/common_mesh.h>

namespace posture {

/// Unit normals of the vertices, faces weighted by their area; zero for a vertex in no face.
Points vertexNormals(const TriangleMesh& mesh);

/// Whether a map keeps the outside out: over the faces of a common mesh, laid onto the target, the
/// mean sign of their normal against the target's own, weighted by area. 1: every face looks the
/// way the target does; -1: the body is turned inside out, as a mirrored map does; 0: no face.
/// Both surfaces must be oriented.
/// \param target_normals  c x 3: the target's normal at each vertex of the common mesh.
double orientationVote(const CommonMesh& mesh, const Points& target_normals);

}  // namespace posture
