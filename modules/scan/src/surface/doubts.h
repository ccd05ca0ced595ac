// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/types.h>

namespace posture {

/// Places where parts that touch may have been joined: groups of edges whose ends look at each
/// other across a concave gap, and between whose ends the way without such edges is at least
/// twenty spacings long. A deep crease looks the same. \param normals  of the vertices
int possibleContacts(const TriangleMesh& mesh, const Points& normals, double spacing);

/// Share of the vertices with the other side of the part less than three spacings behind them;
/// where the mesh is denser, three of its edges. \pre  every vertex is in a face.
double thinShare(const TriangleMesh& mesh, double spacing);

}  // namespace posture
