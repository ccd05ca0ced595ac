// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/mesh/edges.h>
#include <posture/mesh/normals.h>
#include <posture/refine/partners.h>

#include "elsewhere.h"

namespace posture {
namespace {

/// A vertex more than an edge from its match, which is the rim of a hole or does not count; or one
/// whose match does not count and belongs to another part of the surface.
std::vector<char> overHoles(const BendableSurface& a,
                            const BendableSurface& b,
                            const BentPair& pair) {
  const double edge = meanEdgeLength(b.mesh);
  std::vector<char> over(pair.maps.forward.size(), 0);
  for (std::size_t v = 0; v < over.size(); ++v) {
    const int t = pair.maps.forward[v];
    const auto i = static_cast<Eigen::Index>(v);
    const bool is_apart = isApart(pair.apart_a, v);
    over[v] = ((is_apart || (b.on_boundary[t] && !a.on_boundary[v])) &&
               (pair.bent_a.row(i) - b.mesh.vertices.row(t)).norm() > edge) ||
              (is_apart && liesElsewhere(a, i, t, pair.maps.backward, pair.apart_b));
  }
  return over;
}

/// Vertices around which the bent surface looks the other way than what it lies on: a back laid on
/// the inside of a front, where only that was seen.
std::vector<char> onTheInside(const BendableSurface& a,
                              const BendableSurface& b,
                              const BentPair& pair) {
  const int n = static_cast<int>(pair.maps.forward.size());
  const Points normals = vertexNormals({pair.bent_a, a.mesh.faces});
  Vector agreement(n);
  for (int v = 0; v < n; ++v)
    agreement[v] = normals.row(v).dot(b.normals.row(pair.maps.forward[v]));
  std::vector<char> inside(n);
  for (int v = 0; v < n; ++v) {
    double around = agreement[v];
    for (const int* w = a.neighbors.begin(v); w != a.neighbors.end(v); ++w) around += agreement[*w];
    inside[v] = around < 0;
  }
  return inside;
}

}  // namespace

std::vector<char> withoutPartner(const BendableSurface& a,
                                 const BendableSurface& b,
                                 const BentPair& pair,
                                 bool laid) {
  std::vector<char> without = overHoles(a, b, pair);
  if (!laid) return without;
  const std::vector<char> inside = onTheInside(a, b, pair);
  for (std::size_t v = 0; v < inside.size(); ++v) without[v] |= inside[v];
  return without;
}

}  // namespace posture
