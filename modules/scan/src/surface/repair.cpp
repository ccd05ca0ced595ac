// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "surface/repair.h"

#include <posture/core/compact_vertices.h>
#include <posture/mesh/connected_parts.h>

#include <algorithm>
#include <utility>

namespace posture {
namespace {

/// For each vertex its corners, numbered 3 f + k.
struct Corners {
  Corners(const Faces& faces, int vertex_count)
      : first(vertex_count + 1, 0), corners(faces.size()) {
    for (int c = 0; c < faces.size(); ++c) ++first[faces.data()[c] + 1];
    for (int v = 0; v < vertex_count; ++v) first[v + 1] += first[v];
    std::vector<int> next(first.begin(), first.end() - 1);
    for (int c = 0; c < faces.size(); ++c) corners[next[faces.data()[c]]++] = c;
  }

  std::vector<int> first;  ///< n + 1
  std::vector<int> corners;
};

int following(const Faces& faces, int corner) { return faces(corner / 3, (corner + 1) % 3); }

int preceding(const Faces& faces, int corner) { return faces(corner / 3, (corner + 2) % 3); }

Faces selected(const Faces& faces, const std::vector<char>& keep) {
  Faces kept(std::count(keep.begin(), keep.end(), 1), 3);
  for (int f = 0, row = 0; f < faces.rows(); ++f)
    if (keep[f]) kept.row(row++) = faces.row(f);
  return kept;
}

/// The faces at a vertex outside its largest fan; of equally large ones the first stays.
void markOtherFans(const Faces& faces, std::vector<int> corners, std::vector<int>& marked) {
  std::vector<std::vector<int>> fans;
  while (!corners.empty()) {
    std::vector<int> fan{corners.front()};
    corners.erase(corners.begin());
    const auto move = [&](auto fits) {
      const auto found = std::find_if(corners.begin(), corners.end(), fits);
      if (found == corners.end()) return false;
      fan.push_back(*found);
      corners.erase(found);
      return true;
    };
    int to = preceding(faces, fan.front()), from = following(faces, fan.front());
    while (move([&](int c) { return following(faces, c) == to; }))
      to = preceding(faces, fan.back());
    while (move([&](int c) { return preceding(faces, c) == from; }))
      from = following(faces, fan.back());
    fans.push_back(std::move(fan));
  }
  std::size_t largest = 0;
  for (std::size_t i = 1; i < fans.size(); ++i)
    if (fans[i].size() > fans[largest].size()) largest = i;
  for (std::size_t i = 0; i < fans.size(); ++i)
    if (i != largest)
      for (int corner : fans[i]) marked.push_back(corner / 3);
}

/// Whether an edge joins two vertices, in either direction.
class EdgeSet {
 public:
  EdgeSet(const Faces& faces, int vertex_count) : faces_(faces), corners_(faces, vertex_count) {}

  bool has(int a, int b) const {
    for (int i = corners_.first[a]; i < corners_.first[a + 1]; ++i) {
      const int corner = corners_.corners[i];
      if (following(faces_, corner) == b || preceding(faces_, corner) == b) return true;
    }
    const std::pair<int, int> added = std::minmax(a, b);
    return std::find(added_.begin(), added_.end(), added) != added_.end();
  }
  void add(int a, int b) { added_.emplace_back(std::minmax(a, b)); }
  void forget() { added_.clear(); }

 private:
  const Faces& faces_;
  Corners corners_;
  std::vector<std::pair<int, int>> added_;  ///< in the loop at hand: no other has its vertices
};

/// Triangles across a loop, or none when some edge would be used twice.
std::vector<Eigen::RowVector3i> fill(const Points& vertices,
                                     std::vector<int> loop,
                                     EdgeSet& edges) {
  std::vector<Eigen::RowVector3i> triangles;
  edges.forget();
  while (loop.size() > 3) {
    const std::size_t size = loop.size();
    double shortest = -1;
    std::size_t ear = size;
    for (std::size_t k = 0; k < size; ++k) {
      const int before = loop[(k + size - 1) % size], after = loop[(k + 1) % size];
      const double diagonal = (vertices.row(before) - vertices.row(after)).norm();
      if ((shortest < 0 || diagonal < shortest) && !edges.has(before, after)) {
        shortest = diagonal;
        ear = k;
      }
    }
    if (ear == size) return {};
    const int before = loop[(ear + size - 1) % size], after = loop[(ear + 1) % size];
    triangles.emplace_back(before, loop[ear], after);
    edges.add(before, after);
    loop.erase(loop.begin() + static_cast<std::ptrdiff_t>(ear));
  }
  triangles.emplace_back(loop[0], loop[1], loop[2]);
  return triangles;
}

}  // namespace

Faces largestFans(const Faces& faces, int vertex_count) {
  const Corners all(faces, vertex_count);
  std::vector<char> keep(faces.rows(), 1);
  std::vector<int> pending(vertex_count), marked, corners;
  for (int v = 0; v < vertex_count; ++v) pending[v] = vertex_count - 1 - v;
  while (!pending.empty()) {
    const int v = pending.back();
    pending.pop_back();
    corners.clear();
    for (int i = all.first[v]; i < all.first[v + 1]; ++i)
      if (keep[all.corners[i] / 3]) corners.push_back(all.corners[i]);
    marked.clear();
    markOtherFans(faces, corners, marked);
    for (int f : marked) {
      keep[f] = 0;
      for (int k = 0; k < 3; ++k) pending.push_back(faces(f, k));
    }
  }
  return selected(faces, keep);
}

std::vector<std::vector<int>> boundaryLoops(const Faces& faces, int vertex_count) {
  const Corners all(faces, vertex_count);
  // From each vertex of the boundary to the next one of the hole.
  std::vector<int> next(vertex_count, -1);
  for (int c = 0; c < faces.size(); ++c) {
    const int a = faces.data()[c], b = following(faces, c);
    bool has_twin = false;
    for (int i = all.first[b]; i < all.first[b + 1]; ++i)
      has_twin = has_twin || following(faces, all.corners[i]) == a;
    if (!has_twin) next[b] = a;
  }
  std::vector<std::vector<int>> loops;
  std::vector<char> visited(vertex_count, 0);
  for (int v = 0; v < vertex_count; ++v) {
    std::vector<int> loop;
    for (int w = v; next[w] >= 0 && !visited[w]; w = next[w]) {
      visited[w] = 1;
      loop.push_back(w);
    }
    if (!loop.empty()) loops.push_back(std::move(loop));
  }
  return loops;
}

Faces closePinHoles(const TriangleMesh& mesh, double perimeter) {
  const int n = static_cast<int>(mesh.vertices.rows());
  EdgeSet edges(mesh.faces, n);
  std::vector<Eigen::RowVector3i> added;
  for (const std::vector<int>& loop : boundaryLoops(mesh.faces, n)) {
    double length = 0;
    for (std::size_t k = 0; k < loop.size(); ++k)
      length +=
          (mesh.vertices.row(loop[k]) - mesh.vertices.row(loop[(k + 1) % loop.size()])).norm();
    if (length > perimeter) continue;
    const std::vector<Eigen::RowVector3i> filling = fill(mesh.vertices, loop, edges);
    added.insert(added.end(), filling.begin(), filling.end());
  }
  Faces faces(mesh.faces.rows() + static_cast<Eigen::Index>(added.size()), 3);
  faces.topRows(mesh.faces.rows()) = mesh.faces;
  for (std::size_t i = 0; i < added.size(); ++i)
    faces.row(mesh.faces.rows() + static_cast<Eigen::Index>(i)) = added[i];
  return faces;
}

Faces withoutSmallPieces(const Faces& faces, int vertex_count, int least, int& dropped) {
  const std::vector<int> piece = leastOfPart(faces, vertex_count);
  std::vector<int> size(vertex_count, 0);
  for (int f = 0; f < faces.rows(); ++f) ++size[piece[faces(f, 0)]];
  dropped = static_cast<int>(
      std::count_if(size.begin(), size.end(), [&](int s) { return s > 0 && s < least; }));
  std::vector<char> keep(faces.rows());
  for (int f = 0; f < faces.rows(); ++f) keep[f] = size[piece[faces(f, 0)]] >= least;
  return selected(faces, keep);
}

TriangleMesh withoutLooseVertices(const TriangleMesh& mesh, std::vector<int>& kept) {
  TriangleMesh smaller{{}, mesh.faces};
  kept = compactVertices(smaller.faces, static_cast<int>(mesh.vertices.rows()));
  smaller.vertices = mesh.vertices(kept, Eigen::all);
  return smaller;
}

}  // namespace posture
