// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/mesh/edges.h>
#include <posture/mesh/normals.h>
#include <posture/refine/partners.h>

namespace posture {
namespace {

/// A vertex more than an edge from its match, which is the rim of a hole or does not count.
std::vector<char> overHoles(const BendableSurface& a,
                            const BendableSurface& b,
                            const BentPair& pair) {
  const double edge = meanEdgeLength(b.mesh);
  std::vector<char> over(pair.maps.forward.size(), 0);
  for (std::size_t v = 0; v < over.size(); ++v) {
    const int t = pair.maps.forward[v];
    over[v] = (isApart(pair.apart_a, v) || (b.on_boundary[t] && !a.on_boundary[v])) &&
              (pair.bent_a.row(v) - b.mesh.vertices.row(t)).norm() > edge;
  }
  return over;
}

/// In square roots of the area, from a vertex to the counterpart of its match: farther, that is
/// another part. Limbs are about that thick, and answers as far from each other are different ones.
constexpr double ANOTHER_PART = 0.1;

/// Whether the match of a vertex belongs to another part of the surface.
bool liesOnAnother(const BendableSurface& a, const BentPair& pair, std::size_t vertex) {
  const int match = pair.maps.forward[vertex];
  return !isApart(pair.apart_b, static_cast<std::size_t>(match)) &&
         (a.mesh.vertices.row(pair.maps.backward[match]) -
          a.mesh.vertices.row(static_cast<Eigen::Index>(vertex)))
                 .norm() > ANOTHER_PART;
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
                                 const HowFound& found) {
  std::vector<char> without = overHoles(a, b, pair);
  if (found.may_lack)
    for (std::size_t v = 0; v < without.size(); ++v) without[v] |= liesOnAnother(a, pair, v);
  if (!found.laid) return without;
  const std::vector<char> inside = onTheInside(a, b, pair);
  for (std::size_t v = 0; v < inside.size(); ++v) without[v] |= inside[v];
  return without;
}

}  // namespace posture
