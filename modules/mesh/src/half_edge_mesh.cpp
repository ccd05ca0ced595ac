// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/error.h>
#include <posture/core/unions.h>
#include <posture/mesh/half_edge_mesh.h>

#include <algorithm>
#include <array>
#include <map>
#include <utility>

namespace posture {
namespace {

using Side = std::pair<std::pair<int, int>, int>;  // ((from, to), half-edge)

std::vector<Side> sortedSides(const Faces& faces) {
  std::vector<Side> sides;
  sides.reserve(3 * faces.rows());
  for (int h = 0; h < 3 * faces.rows(); ++h)
    sides.push_back({{faces(h / 3, h % 3), faces(h / 3, (h + 1) % 3)}, h});
  std::sort(sides.begin(), sides.end());
  return sides;
}

/// The half-edges that run from one vertex to another.
auto running(const std::vector<Side>& sides, int from, int to) {
  return std::equal_range(
      sides.begin(), sides.end(), Side{{from, to}, 0}, [](const Side& a, const Side& b) {
        return a.first < b.first;
      });
}

}  // namespace

HalfEdgeMesh::HalfEdgeMesh(const Faces& faces, int vertex_count)
    : origin_(faces.data(), faces.data() + faces.size()),
      twin_(faces.size(), -1),
      outgoing_(vertex_count, -1) {
  const std::vector<Side> sides = sortedSides(faces);
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const auto [from, to] = sides[i].first;
    require(from >= 0 && from < vertex_count, "HalfEdgeMesh: face index out of range");
    require(i == 0 || sides[i - 1].first != sides[i].first,
            "HalfEdgeMesh: an edge of more than two faces, or faces oriented against each other");
    const auto [first, last] = running(sides, to, from);
    if (first != last) twin_[sides[i].second] = first->second;
  }
  for (int h = halfEdgeCount() - 1; h >= 0; --h) {
    const int v = origin_[h];
    if (outgoing_[v] < 0 || twin_[h] < 0) outgoing_[v] = h;
  }
  const std::string fault = check();
  require(fault.empty(), "HalfEdgeMesh: " + fault);
}

int HalfEdgeMesh::liveVertexCount() const {
  return static_cast<int>(
      std::count_if(outgoing_.begin(), outgoing_.end(), [](int h) { return h >= 0; }));
}

int HalfEdgeMesh::liveFaceCount() const {
  return static_cast<int>(
             std::count_if(origin_.begin(), origin_.end(), [](int v) { return v >= 0; })) /
         3;
}

std::vector<int> HalfEdgeMesh::star(int v) const {
  std::vector<int> half_edges;
  const int first = outgoing_[v];
  for (int h = first; h >= 0;) {
    half_edges.push_back(h);
    h = twin_[previous(h)];
    if (h == first) break;
  }
  return half_edges;
}

std::vector<int> HalfEdgeMesh::neighbors(int v) const {
  std::vector<int> around;
  for (int h : star(v)) around.push_back(target(h));
  if (isBoundaryVertex(v)) around.push_back(origin_[previous(star(v).back())]);
  return around;
}

int HalfEdgeMesh::find(int from, int to) const {
  for (int h : star(from))
    if (target(h) == to) return h;
  return -1;
}

std::vector<std::vector<int>> HalfEdgeMesh::boundaryLoops() const {
  std::vector<std::vector<int>> loops;
  std::vector<char> seen(origin_.size(), 0);
  for (int start = 0; start < halfEdgeCount(); ++start) {
    if (!isLive(start) || twin_[start] >= 0 || seen[start]) continue;
    loops.emplace_back();
    // One fan a vertex: of each on the boundary one half-edge without a twin goes out.
    for (int h = start; !seen[h]; h = outgoing_[target(h)]) {
      seen[h] = 1;
      loops.back().push_back(h);
    }
  }
  return loops;
}

bool HalfEdgeMesh::canCollapse(int from, int into) const {
  const int h = find(from, into);
  const int t = h >= 0 ? twin_[h] : find(into, from);
  if (h < 0 && t < 0) return false;
  const bool edge_on_boundary = h < 0 || t < 0;
  if (isBoundaryVertex(from) && isBoundaryVertex(into) && !edge_on_boundary) return false;

  std::vector<int> around_from = neighbors(from), around_into = neighbors(into), common;
  std::sort(around_from.begin(), around_from.end());
  std::sort(around_into.begin(), around_into.end());
  std::set_intersection(around_from.begin(),
                        around_from.end(),
                        around_into.begin(),
                        around_into.end(),
                        std::back_inserter(common));
  const int faces_at_edge = (h >= 0) + (t >= 0);
  if (static_cast<int>(common.size()) != faces_at_edge) return false;
  // The vertices opposite lose a neighbour: a closed fan needs three, an open one two.
  for (int w : common)
    if (neighbors(w).size() <= (isBoundaryVertex(w) ? 2u : 3u)) return false;
  // A lone triangle may not fold into an edge.
  return !(edge_on_boundary && around_from.size() == 2 && around_into.size() == 2);
}

void HalfEdgeMesh::collapse(int from, int into) {
  const std::vector<int> moved = star(from);
  const int h = find(from, into);
  const int t = h >= 0 ? twin_[h] : find(into, from);
  std::vector<int> survivors;  // half-edges whose origins lost a face
  for (int side : {h, t}) {
    if (side < 0) continue;
    const int a = twin_[next(side)], b = twin_[previous(side)];
    const int opposite = origin_[previous(side)];
    if (a >= 0) twin_[a] = b;
    if (b >= 0) twin_[b] = a;
    for (int g : {a, b})
      if (g >= 0) survivors.insert(survivors.end(), {g, next(g)});
    outgoing_[opposite] = -1;
  }
  for (int g : moved) origin_[g] = into;
  for (int side : {h, t})
    if (side >= 0) removeFace(side);
  outgoing_[from] = -1;
  survivors.insert(survivors.end(), moved.begin(), moved.end());
  for (int g : survivors)
    if (isLive(g)) resetOutgoing(origin_[g], g);
}

bool HalfEdgeMesh::canFlip(int h) const {
  const int t = twin_[h];
  if (t < 0) return false;
  const int c = origin_[previous(h)], d = origin_[previous(t)];
  if (c == d || find(c, d) >= 0 || find(d, c) >= 0) return false;
  for (int end : {origin_[h], origin_[t]})
    if (neighbors(end).size() <= (isBoundaryVertex(end) ? 2u : 3u)) return false;
  return true;
}

void HalfEdgeMesh::flip(int h) {
  const int t = twin_[h];
  const int a = origin_[h], b = origin_[t], c = origin_[previous(h)], d = origin_[previous(t)];
  const int bc = twin_[next(h)], ca = twin_[previous(h)];
  const int ad = twin_[next(t)], db = twin_[previous(t)];
  const auto set =
      [&](int first, const std::array<int, 3>& corners, const std::array<int, 3>& twins) {
        int g = first;
        for (int k = 0; k < 3; ++k, g = next(g)) {
          origin_[g] = corners[k];
          twin_[g] = twins[k];
          if (twins[k] >= 0) twin_[twins[k]] = g;
        }
      };
  // h becomes d -> c and t becomes c -> d.
  set(h, {d, c, a}, {t, ca, ad});
  set(t, {c, d, b}, {h, db, bc});
  for (int g : {h, next(h), previous(h), t, next(t), previous(t)}) resetOutgoing(origin_[g], g);
}

void HalfEdgeMesh::removeFace(int h) {
  for (int g : {h, next(h), previous(h)}) origin_[g] = twin_[g] = -1;
}

void HalfEdgeMesh::resetOutgoing(int v, int any_live_half_edge) {
  int h = any_live_half_edge;
  while (twin_[h] >= 0) {
    h = next(twin_[h]);
    if (h == any_live_half_edge) break;
  }
  outgoing_[v] = h;
}

Faces HalfEdgeMesh::faces() const {
  Faces live(liveFaceCount(), 3);
  int row = 0;
  for (int h = 0; h < halfEdgeCount(); h += 3)
    if (isLive(h)) live.row(row++) << origin_[h], origin_[h + 1], origin_[h + 2];
  return live;
}

std::string HalfEdgeMesh::check() const {
  std::vector<std::pair<int, int>> directed;
  std::vector<int> leaving(outgoing_.size(), 0);
  for (int h = 0; h < halfEdgeCount(); ++h) {
    if (!isLive(h)) continue;
    if (!isLive(next(h))) return "a face is half removed";
    if (origin_[h] == target(h)) return "a face has a corner twice";
    const int t = twin_[h];
    if (t >= 0 &&
        (!isLive(t) || twin_[t] != h || origin_[t] != target(h) || target(t) != origin_[h]))
      return "twins do not match";
    directed.emplace_back(origin_[h], target(h));
    ++leaving[origin_[h]];
  }
  std::sort(directed.begin(), directed.end());
  if (std::adjacent_find(directed.begin(), directed.end()) != directed.end())
    return "two half-edges run the same way between the same vertices";
  for (int v = 0; v < vertexCount(); ++v) {
    const int h = outgoing_[v];
    if ((h < 0) != (leaving[v] == 0)) return "a vertex with faces has no outgoing half-edge";
    if (h < 0) continue;
    if (!isLive(h) || origin_[h] != v) return "an outgoing half-edge starts elsewhere";
    if (static_cast<int>(star(v).size()) != leaving[v])
      return "a vertex joins several fans, or its outgoing half-edge is not the first of its fan";
  }
  return {};
}

ManifoldMesh cutNonManifold(const TriangleMesh& mesh) {
  const Faces& faces = mesh.faces;
  const std::vector<Side> sides = sortedSides(faces);
  // Corners that stay one vertex: those joined across an edge of exactly two agreeing faces.
  const int corner_count = static_cast<int>(faces.size());
  Unions corners(corner_count);
  for (const Side& side : sides) {
    const auto [from, to] = side.first;
    const auto same = running(sides, from, to), opposite = running(sides, to, from);
    if (same.second - same.first != 1 || opposite.second - opposite.first != 1) continue;
    const int h = side.second, t = opposite.first->second;
    corners.join(h, HalfEdgeMesh::next(t));
    corners.join(HalfEdgeMesh::next(h), t);
  }

  ManifoldMesh result;
  const int n = static_cast<int>(mesh.vertices.rows());
  std::vector<int> fan_of(n, -1);  // the first fan met keeps the vertex's number
  std::map<int, int> copy_of_fan;
  result.original_vertex.resize(n);
  for (int v = 0; v < n; ++v) result.original_vertex[v] = v;
  result.mesh.faces = faces;
  for (int c = 0; c < corner_count; ++c) {
    const int v = faces.data()[c], fan = corners.root(c);
    if (fan_of[v] < 0) fan_of[v] = fan;
    if (fan_of[v] == fan) continue;
    const auto [copy, is_new] =
        copy_of_fan.try_emplace(fan, static_cast<int>(result.original_vertex.size()));
    if (is_new) result.original_vertex.push_back(v);
    result.mesh.faces.data()[c] = copy->second;
  }
  result.mesh.vertices.resize(result.original_vertex.size(), 3);
  for (std::size_t v = 0; v < result.original_vertex.size(); ++v)
    result.mesh.vertices.row(v) = mesh.vertices.row(result.original_vertex[v]);
  return result;
}

}  // namespace posture
