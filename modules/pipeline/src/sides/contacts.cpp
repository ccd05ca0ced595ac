// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sides/contacts.h"

#include <posture/core/error.h>
#include <posture/core/parallel.h>
#include <posture/core/shortest_ways.h>
#include <posture/deformation/reduce_mesh.h>
#include <posture/mesh/areas.h>
#include <posture/mesh/connected_parts.h>
#include <posture/mesh/edge_paths.h>
#include <posture/mesh/half_edge_mesh.h>
#include <posture/mesh/handles.h>
#include <posture/mesh/vertex_neighbors.h>

#include "sides/contact_seam.h"
#include "sides/cut_surface.h"
#include <algorithm>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

namespace posture {
namespace {

/// Rings are looked for on so many vertices, from so many of them: wherever one starts, the
/// shortest loops go around every handle.
constexpr int VERTICES = 5000, STARTS = 20;

/// On so many vertices at most folds are looked for: what scanning joined folds within two spacings
/// of a scan, and less and less sharply within those of a finer mesh.
constexpr int SEAM_VERTICES = 25000;

/// A handle matters when the way around it is long, in square roots of the area: several spacings
/// of the samples whose distances are compared.
constexpr double LEAST_DETOUR = 0.25;

/// So many loops from each place are followed to where they are narrowest, and so many handles are
/// opened: a body has a hand or two on its hips, what has far more is no body grown together.
constexpr int MOST_LOOPS = 20, MOST_RINGS = 10;

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

/// How far it is from one side of a ring to the other on a mesh without the faces at the ring.
class Detours {
 public:
  explicit Detours(const TriangleMesh& mesh) : mesh_(mesh), first_(mesh.vertices.rows() + 1, 0) {
    for (int v : mesh.faces.reshaped()) first_[v + 1] += 2;
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    steps_.resize(first_.back());
    std::vector<int> next(first_.begin(), first_.end() - 1);
    for (const auto& face : mesh.faces.rowwise())
      for (int k = 0; k < 3; ++k) {
        const int v = face[k], one = face[(k + 1) % 3], other = face[(k + 2) % 3];
        steps_[next[v]++] = {one, other};
        steps_[next[v]++] = {other, one};
      }
  }

  /// Whether the way around is longer than `least`; not where there is none, or no telling the
  /// sides apart.
  bool isLong(const Ring& ring, double least) const {
    std::vector<char> on_ring(first_.size() - 1, 0), beside(first_.size() - 1, 0);
    for (int v : ring.vertices) on_ring[v] = 1;
    int begin = std::numeric_limits<int>::max();
    for (int v : ring.vertices)
      for (int i = first_[v]; i < first_[v + 1]; ++i)
        if (const int w = steps_[i].to; !on_ring[w]) {
          beside[w] = 1;
          begin = std::min(begin, w);
        }
    if (begin == std::numeric_limits<int>::max()) return false;
    const auto forEachNext = [&](int v, const auto& body) {
      for (int i = first_[v]; i < first_[v + 1]; ++i)
        if (!on_ring[steps_[i].to] && !on_ring[steps_[i].third]) body(steps_[i].to);
    };
    // One side: what is joined along the ring.
    std::vector<int> side{begin};
    beside[begin] = 0;
    for (std::size_t i = 0; i < side.size(); ++i)
      forEachNext(side[i], [&](int w) {
        if (!beside[w]) return;
        beside[w] = 0;
        side.push_back(w);
      });
    // The nearest place of the other one.
    ShortestWays ways(static_cast<int>(beside.size()));
    bool is_long = false;
    ways.search(
        side,
        [&](int v, const auto& step) {
          forEachNext(
              v, [&](int w) { step(w, (mesh_.vertices.row(v) - mesh_.vertices.row(w)).norm()); });
        },
        [&](int v) {
          if (!beside[v]) return true;
          is_long = ways.distance(v) > least;
          return false;
        });
    return is_long;
  }

 private:
  /// Along an edge of a face whose third corner is another.
  struct Step {
    int to, third;
  };

  const TriangleMesh& mesh_;
  std::vector<int> first_;
  std::vector<Step> steps_;
};

/// A narrower ring around the same handle is often found from the far side.
void narrow(const Handles& handles, const TriangleMesh& mesh, Ring& ring) {
  for (;;) {
    std::vector<int> other = handles.loopsThrough(ring.vertices[ring.vertices.size() / 2]).front();
    const double length = lengthOf(mesh, other);
    if (length >= ring.length) return;
    ring = {std::move(other), length};
  }
}

/// The narrowest ring that opens a handle with a long way around; none: there is no such handle.
std::optional<Ring> contactRing(const TriangleMesh& mesh) {
  const Handles handles(mesh);
  if (handles.count() == 0) return {};
  const Detours detours(mesh);
  const double least_detour = LEAST_DETOUR * rootArea(mesh);
  const int starts = std::min<int>(STARTS, static_cast<int>(mesh.vertices.rows()));
  std::vector<std::optional<Ring>> rings(starts);
  parallelFor(starts, [&](int start) {
    int followed = 0;
    for (std::vector<int>& loop : handles.loopsThrough(start)) {
      Ring ring{std::move(loop), 0};
      ring.length = lengthOf(mesh, ring.vertices);
      // A handle that is small in both ways, as noise makes by the hundred.
      if (ring.length < least_detour && !detours.isLong(ring, least_detour)) continue;
      if (++followed > MOST_LOOPS) break;
      narrow(handles, mesh, ring);
      if ((!rings[start] || ring.length < rings[start]->length) &&
          detours.isLong(ring, least_detour))
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
  const int cut_n = static_cast<int>(cut.mesh.vertices.rows());
  std::vector<std::vector<int>> copies(n);
  for (int c = n; c < cut_n; ++c) copies[cut.original_vertex[c]].push_back(c);
  const VertexNeighbors neighbors(mesh.faces, n);
  const std::vector<int> part = leastOfPart(cut.mesh.faces, cut_n);
  const EdgePaths paths(cut.mesh);
  const double least_detour = LEAST_DETOUR * rootArea(mesh);
  std::vector<int> welded;
  std::vector<char> has_copies(n);
  for (int v = 0; v < n; ++v) has_copies[v] = !copies[v].empty();
  for (const std::vector<int>& place : markedParts(neighbors, has_copies)) {
    const int start = place.front();
    std::vector<int> joined;  // in some other way
    for (int c : copies[start])
      if (part[c] == part[start]) joined.push_back(c);
    if (paths.reachesAll(start, joined, least_detour)) continue;
    welded.insert(welded.end(), place.begin(), place.end());
    ++contacts;
  }
  return welded;
}

/// The vertices on the shortest ways of some steps, one after the other, with both ends of each.
std::vector<int> onTheWay(const TriangleMesh& mesh, const std::vector<std::pair<int, int>>& steps) {
  const EdgePaths paths(mesh);
  std::vector<int> along;
  for (const auto& [from, to] : steps) {
    const std::vector<int> path = paths.shortest(from, to);
    along.insert(along.end(), path.begin(), path.end());
  }
  return along;
}

/// Vertices along the contact that opens a handle with a long way around; none: there is no such
/// handle.
/// \throws InputError  the surface falls apart on fewer vertices
std::vector<int> alongContact(const TriangleMesh& surface) {
  std::optional<ReducedMesh> less;
  if (surface.vertices.rows() > SEAM_VERTICES) less = reduceMesh(surface, SEAM_VERTICES);
  const TriangleMesh& fine = less ? less->mesh : surface;
  const ReducedMesh reduced = reduceMesh(fine, VERTICES);
  const ManifoldMesh manifold = cutNonManifold(reduced.mesh);
  const std::optional<Ring> ring = contactRing(manifold.mesh);
  if (!ring) return {};
  std::vector<std::pair<int, int>> steps;
  const auto place = [&](std::size_t i) {
    return reduced.vertex[manifold.original_vertex[ring->vertices[i % ring->vertices.size()]]];
  };
  for (std::size_t i = 0; i < ring->vertices.size(); ++i)
    steps.emplace_back(place(i), place(i + 1));
  std::vector<std::pair<int, int>> seam = contactSeam(fine, onTheWay(fine, steps));
  if (less)
    for (auto& [from, to] : seam) {
      from = less->vertex[from];
      to = less->vertex[to];
    }
  return onTheWay(surface, seam);
}

}  // namespace

PartedSurface partedSurface(const TriangleMesh& input, const CleanMesh& clean) {
  CutSurface cut(input, clean);
  int contacts = 0;
  const std::vector<int> welded = weldedContacts(clean.mesh, contacts);
  if (!welded.empty() && !cut.cutOut(welded)) return {clean, 0, cut.gone()};
  for (int rings = 0; rings < MOST_RINGS; ++rings) {
    const TriangleMesh& surface = cut.clean().mesh;
    if (Handles(cutNonManifold(surface).mesh).count() == 0) break;
    std::vector<int> along;
    try {
      along = alongContact(surface);
    } catch (const InputError&) {  // too few faces in twos for a handle to be told
    }
    if (along.empty() || !cut.cutOut(along)) break;
    ++contacts;
  }
  return {cut.clean(), contacts, cut.gone()};
}

}  // namespace posture
