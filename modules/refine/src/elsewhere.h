// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/refine/settle.h>

#include <vector>

namespace posture {

/// Whether the place a vertex of `a` lies on belongs to another part of `a`: its own counterpart is
/// farther from the vertex than a tenth of the square root of the area. A forearm that was let go
/// of, because the other surface lacks it, comes to lie on the hip by chance.
/// \param match     of the vertex
/// \param backward  of the vertices of the other surface
/// \param apart     those of them whose matches do not count, as in BentPair
inline bool liesElsewhere(const BendableSurface& a,
                          Eigen::Index vertex,
                          int match,
                          const std::vector<int>& backward,
                          const std::vector<char>& apart) {
  constexpr double FAR = 0.1;
  return !isApart(apart, static_cast<std::size_t>(match)) &&
         (a.mesh.vertices.row(backward[match]) - a.mesh.vertices.row(vertex)).norm() > FAR;
}

}  // namespace posture
