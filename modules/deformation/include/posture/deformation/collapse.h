// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/types.h>

#include <vector>

namespace posture {

/// Removes every vertex that is not kept by half-edge collapses, always the one with the least
/// change of volume first (Lindstrom and Turk 1998; section 5.1): the sum over the moved faces of
/// the squared volume between old and new, with the squared area lost at the boundary weighted by
/// the squared edge length; of equal ones the shortest edge. A collapse that would change the
/// topology or flip a face is not made; when nothing else is left, flips are.
///
/// Vertices that no collapse can remove (a tunnel or a loose part without enough kept vertices) go
/// with their faces, which then leave a hole.
/// \param keep  n, non-zero for the vertices to keep.
/// \return faces between kept vertices, in the numbering of `mesh`. Non-manifold meshes are cut
///         open first, so an edge may have more than two faces again.
/// \throws std::invalid_argument  not one flag a vertex.
Faces collapseToVertices(const TriangleMesh& mesh, const std::vector<char>& keep);

}  // namespace posture
