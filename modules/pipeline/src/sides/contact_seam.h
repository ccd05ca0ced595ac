// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/types.h>

#include <utility>
#include <vector>

namespace posture {

/// Where a surface that a ring opens is most likely grown together: of all closed paths that part
/// the sides of the ring from each other on the surface cut open along it, the cheapest ones, which
/// run where it folds inwards and through holes. An arm that touches the head is narrowest at the
/// wrist, but folds where the hand lies.
/// \param surface  oriented, outside out; folds are looked for across two of its faces.
/// \param ring  vertices in order along edges, repeated in a row or not; the surface stays
/// connected without them. \return  the edges of the paths, those of the ring where no others are
/// cheaper.
std::vector<std::pair<int, int>> contactSeam(const TriangleMesh& surface,
                                             const std::vector<int>& ring);

}  // namespace posture
