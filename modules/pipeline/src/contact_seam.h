// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/types.h>

#include <vector>

namespace posture {

/// Where a surface that a ring opens is most likely grown together: of all closed paths that part
/// the sides of the ring from each other on the surface cut open along it, the cheapest ones, where
/// the surface folds inwards all along and no rim is in the way. An arm that touches the head is
/// narrowest at the wrist, but folds where the hand lies.
/// \param ring  vertices in order along edges, the first not repeated; the surface stays connected
/// without them. \return  vertices on the paths.
std::vector<int> contactSeam(const TriangleMesh& surface, const std::vector<int>& ring);

}  // namespace posture
