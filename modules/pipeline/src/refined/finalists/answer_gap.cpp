// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "refined/finalists/answer_gap.h"

#include <cstddef>

namespace posture {

double gapBetween(const TriangleMesh& target, const VertexMaps& x, const VertexMaps& y) {
  double sum = 0;
  for (std::size_t v = 0; v < x.forward.size(); ++v)
    sum += (target.vertices.row(x.forward[v]) - target.vertices.row(y.forward[v])).norm();
  return sum / static_cast<double>(x.forward.size());
}

}  // namespace posture
