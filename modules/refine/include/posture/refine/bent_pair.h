// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/refine/surface.h>

#include <cstddef>
#include <vector>

namespace posture {

/// Two surfaces, each bent onto the other.
struct BentPair {
  VertexMaps maps;
  Points bent_a;  ///< a's vertices on b
  Points bent_b;  ///< b's vertices on a
  /// Vertices let go of (letGo()), whose matches do not count; empty: none.
  std::vector<char> apart_a{}, apart_b{};
};

/// Whether a vertex is among those let go of. \param apart  of its surface, as in BentPair.
inline bool isApart(const std::vector<char>& apart, std::size_t v) {
  return !apart.empty() && apart[v] != 0;
}

/// The same with the surfaces exchanged.
BentPair reversed(const BentPair& pair);

}  // namespace posture
