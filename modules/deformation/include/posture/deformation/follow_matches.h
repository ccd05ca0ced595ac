// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/types.h>

#include <vector>

namespace posture {

/// Moves a whole mesh by what is known of some of its vertices: these go to their places, each
/// other vertex makes the rigid motion that best fits (Umeyama 1991) the known ones nearest to it
/// along the edges.
/// \param known   n, non-zero where `places` holds the vertex's new place.
/// \param places  n x 3.
/// \param extra, anchor  further points (e x 3) and the vertex each of them moves along with.
/// \return (n + e) x 3. Without any known vertex nothing moves.
Points followMatches(const TriangleMesh& mesh,
                     const std::vector<char>& known,
                     const Points& places,
                     const Points& extra,
                     const std::vector<int>& anchor);

}  // namespace posture
