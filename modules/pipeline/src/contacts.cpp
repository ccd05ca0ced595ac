// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "contacts.h"

#include <posture/core/parallel.h>
#include <posture/deformation/reduce_mesh.h>
#include <posture/mesh/edges.h>
#include <posture/mesh/half_edge_mesh.h>
#include <posture/mesh/handles.h>
#include <posture/mesh/vertex_neighbors.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace posture {
namespace {

/// Rings are looked for on so many vertices, from so many of them: wherever one starts, the shortest
/// loops go around every handle.
constexpr int VERTICES = 5000, STARTS = 20;

/// A handle matters when the way around it is long, in square roots of the area: several spacings
/// of the samples whose distances are compared.
constexpr double LEAST_DETOUR = 0.25;

struct Ring {
  std::vector<int> vertices;
  double length = 0;
};

double lengthOf(const TriangleMesh& mesh, const std::vector<int>& loop) {
  double sum = 0;
  for (std::size_t i = 0; i < loop.size(); ++i)
    sum += (mesh.vertices.row(loop[i]) - mesh.vertices.row(loop[(i + 1) % loop.size()])).norm();
  return sum;
}

/// How far it is from one side of the ring to the other without crossing it; 0 where there is no
/// telling the sides apart.
double detourAround(const TriangleMesh& mesh, const Ring& ring) {
  const int n = static_cast<int>(mesh.vertices.rows());
  std::vector<char> on_ring(n, 0), beside(n, 0);
  for (int v : ring.vertices) on_ring[v] = 1;
  TriangleMesh rest{mesh.vertices, Faces(mesh.faces.rows(), 3)};
  Eigen::Index kept = 0;
  for (int f = 0; f < mesh.faces.rows(); ++f) {
    const Eigen::RowVector3i face = mesh.faces.row(f);
    if (std::none_of(face.data(), face.data() + 3, [&](int v) { return on_ring[v] != 0; }))
      rest.faces.row(kept++) = face;
    else
      for (int v : face)
        if (!on_ring[v]) beside[v] = 1;
  }
  rest.faces.conservativeResize(kept, 3);
  // One side: what is joined along the ring.
  const VertexNeighbors neighbors(rest.faces, n);
  std::vector<int> side;
  for (int v = 0; v < n && side.empty(); ++v)
    if (beside[v]) side.push_back(v);
  for (std::size_t i = 0; i < side.size(); ++i) {
    beside[side[i]] = 0;
    for (const int* w = neighbors.begin(side[i]); w != neighbors.end(side[i]); ++w)
      if (beside[*w]) {
        beside[*w] = 0;
        side.push_back(*w);
      }
  }
  const Vector distance = pathLengths(rest, side);
  double detour = std::numeric_limits<double>::infinity();
  for (int v = 0; v < n; ++v)
    if (beside[v]) detour = std::min(detour, distance[v]);
  return std::isfinite(detour) ? detour : 0;
}

/// The narrowest ring that opens a handle with a long way around; none: there is no such handle.
std::optional<Ring> contactRing(const TriangleMesh& mesh) {
  const Handles handles(mesh);
  if (handles.count() == 0) return {};
  const double least_detour = LEAST_DETOUR * std::sqrt(faceAreas(mesh).sum());
  const int starts = std::min<int>(STARTS, static_cast<int>(mesh.vertices.rows()));
  std::vector<std::optional<Ring>> rings(starts);
  parallelFor(starts, [&](int start) {
    for (std::vector<int>& loop : handles.loopsThrough(start)) {
      Ring ring{std::move(loop), 0};
      ring.length = lengthOf(mesh, ring.vertices);
      // A narrower one is often found from the far side.
      for (;;) {
        std::vector<int> other =
            handles.loopsThrough(ring.vertices[ring.vertices.size() / 2]).front();
        const double length = lengthOf(mesh, other);
        if (length >= ring.length) break;
        ring = {std::move(other), length};
      }
      if ((!rings[start] || ring.length < rings[start]->length) &&
          detourAround(mesh, ring) > least_detour)
        rings[start] = std::move(ring);
    }
  });
  std::optional<Ring> narrowest;
  for (const std::optional<Ring>& ring : rings)
    if (ring && (!narrowest || ring->length < narrowest->length)) narrowest = ring;
  return narrowest;
}

/// Vertices where the surface touches itself and the way around is long: edges of more than two
/// faces, and vertices of several fans, as where points of two parts were welded.
std::vector<int> weldedContacts(const TriangleMesh& mesh, int& contacts) {
  const ManifoldMesh cut = cutNonManifold(mesh);
  const int n = static_cast<int>(mesh.vertices.rows());
  std::vector<std::vector<int>> copies(n);
  for (int c = n; c < cut.mesh.vertices.rows(); ++c) copies[cut.original_vertex[c]].push_back(c);
  const VertexNeighbors neighbors(mesh.faces, n);
  const double least_detour = LEAST_DETOUR * std::sqrt(faceAreas(mesh).sum());
  std::vector<int> welded;
  std::vector<char> seen(n, 0);
  for (int start = 0; start < n; ++start) {
    if (copies[start].empty() || seen[start]) continue;
    std::vector<int> place{start};
    seen[start] = 1;
    for (std::size_t i = 0; i < place.size(); ++i)
      for (const int* w = neighbors.begin(place[i]); w != neighbors.end(place[i]); ++w)
        if (!copies[*w].empty() && !seen[*w]) {
          seen[*w] = 1;
          place.push_back(*w);
        }
    const Vector distance = pathLengths(cut.mesh, {start});
    if (std::none_of(copies[start].begin(), copies[start].end(), [&](int c) {
          return std::isfinite(distance[c]) && distance[c] > least_detour;
        }))
      continue;
    welded.insert(welded.end(), place.begin(), place.end());
    ++contacts;
  }
  return welded;
}

/// The input without faces that touch the clean vertices.
TriangleMesh without(const TriangleMesh& input,
                     const CleanMesh& clean,
                     const std::vector<int>& vertices) {
  std::vector<char> gone(clean.mesh.vertices.rows(), 0);
  for (int v : vertices) gone[v] = 1;
  TriangleMesh cut{input.vertices, Faces(input.faces.rows(), 3)};
  Eigen::Index kept = 0;
  for (int f = 0; f < input.faces.rows(); ++f) {
    const Eigen::RowVector3i face = input.faces.row(f);
    const bool touches = std::any_of(face.data(), face.data() + 3, [&](int v) {
      return clean.offset[v] == 0 && gone[clean.clean_vertex[v]];
    });
    if (!touches) cut.faces.row(kept++) = face;
  }
  cut.faces.conservativeResize(kept, 3);
  return cut;
}

}  // namespace

PartedSurface partedSurface(const TriangleMesh& input, const CleanMesh& clean) {
  PartedSurface parted{clean, 0};
  TriangleMesh cut = input;
  const std::vector<int> welded = weldedContacts(clean.mesh, parted.contacts);
  if (!welded.empty()) {
    cut = without(cut, clean, welded);
    parted.clean = cleanMesh(cut);
  }
  for (;;) {
    const TriangleMesh& surface = parted.clean.mesh;
    if (Handles(cutNonManifold(surface).mesh).count() == 0) return parted;
    const ReducedMesh reduced = reduceMesh(surface, VERTICES);
    const ManifoldMesh manifold = cutNonManifold(reduced.mesh);
    const std::optional<Ring> ring = contactRing(manifold.mesh);
    if (!ring) return parted;
    std::vector<int> along;
    const auto place = [&](std::size_t i) {
      return reduced.vertex[manifold.original_vertex[ring->vertices[i % ring->vertices.size()]]];
    };
    for (std::size_t i = 0; i < ring->vertices.size(); ++i) {
      const std::vector<int> path = shortestPath(surface, place(i), place(i + 1));
      along.insert(along.end(), path.begin(), path.end());
    }
    cut = without(cut, parted.clean, along);
    parted.clean = cleanMesh(cut);
    ++parted.contacts;
  }
}

}  // namespace posture
