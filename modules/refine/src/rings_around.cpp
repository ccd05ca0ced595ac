// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "rings_around.h"

#include <utility>

namespace posture {

std::vector<int> ringsAround(const BendableSurface& surface,
                             std::vector<int> front,
                             std::vector<char> seen,
                             long rings) {
  const VertexNeighbors& neighbors = surface.neighbors;
  std::vector<int> found;
  for (long ring = 0; ring < rings; ++ring) {
    std::vector<int> next;
    for (int v : front)
      for (const int* w = neighbors.begin(v); w != neighbors.end(v); ++w)
        if (seen[*w] == 0) {
          seen[*w] = 1;
          next.push_back(*w);
        }
    found.insert(found.end(), next.begin(), next.end());
    front = std::move(next);
  }
  return found;
}

}  // namespace posture
