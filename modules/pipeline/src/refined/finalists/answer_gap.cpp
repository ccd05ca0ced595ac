// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "refined/finalists/answer_gap.h"

#include <cstddef>
#include <limits>

namespace posture {

namespace {

template <class IsLeftOut>
double meanGap(const TriangleMesh& target,
               const VertexMaps& x,
               const VertexMaps& y,
               const IsLeftOut& is_left_out) {
  double sum = 0;
  int both = 0;
  for (std::size_t v = 0; v < x.forward.size(); ++v) {
    if (is_left_out(v)) continue;
    ++both;
    sum += (target.vertices.row(x.forward[v]) - target.vertices.row(y.forward[v])).norm();
  }
  return both > 0 ? sum / both : std::numeric_limits<double>::infinity();
}

}  // namespace

double gapBetween(const TriangleMesh& target, const VertexMaps& x, const VertexMaps& y) {
  return meanGap(target, x, y, [](std::size_t) { return false; });
}

double gapBetween(const TriangleMesh& target, const BentPair& x, const BentPair& y) {
  return meanGap(target, x.maps, y.maps, [&](std::size_t v) {
    return isApart(x.apart_a, v) || isApart(y.apart_a, v);
  });
}

}  // namespace posture
