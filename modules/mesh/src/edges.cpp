// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/mesh/edges.h>

#include <algorithm>
#include <tuple>

namespace posture {

namespace {

/// A side of a face, seen as the edge it lies on.
struct Side {
  int first;  ///< < second
  int second;
  int number;  ///< 3 face + k

  auto edge() const { return std::tie(first, second); }
};

/// By edge, then by number.
std::vector<Side> sortedSides(const Faces& faces) {
  std::vector<Side> sides;
  sides.reserve(faces.size());
  for (int h = 0; h < faces.size(); ++h) {
    const auto [a, b] = std::minmax(faces(h / 3, h % 3), faces(h / 3, (h + 1) % 3));
    sides.push_back({a, b, h});
  }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    return std::tie(a.first, a.second, a.number) < std::tie(b.first, b.second, b.number);
  });
  return sides;
}

}  // namespace

std::vector<Edge> meshEdges(const Faces& faces) {
  std::vector<Edge> edges;
  for (const Side& side : sortedSides(faces)) {
    if (!edges.empty() && side.edge() == std::tie(edges.back().first, edges.back().second))
      ++edges.back().faces;
    else
      edges.push_back({side.first, side.second, 1});
  }
  return edges;
}

Faces facesAcross(const Faces& faces) {
  const std::vector<Side> sides = sortedSides(faces);
  Faces across = Faces::Constant(faces.rows(), 3, -1);
  for (std::size_t begin = 0, end = 0; begin < sides.size(); begin = end) {
    while (end < sides.size() && sides[end].edge() == sides[begin].edge()) ++end;
    if (end - begin != 2) continue;
    const int a = sides[begin].number, b = sides[begin + 1].number;
    across.data()[a] = b / 3;
    across.data()[b] = a / 3;
  }
  return across;
}

double meanEdgeLength(const TriangleMesh& mesh) {
  double sum = 0;
  const std::vector<Edge> edges = meshEdges(mesh.faces);
  for (const Edge& e : edges)
    sum += (mesh.vertices.row(e.first) - mesh.vertices.row(e.second)).norm();
  return edges.empty() ? 0 : sum / static_cast<double>(edges.size());
}

std::vector<char> boundaryVertices(const Faces& faces, int vertex_count) {
  std::vector<char> on_boundary(vertex_count, 0);
  for (const Edge& e : meshEdges(faces))
    if (e.faces == 1) on_boundary[e.first] = on_boundary[e.second] = 1;
  return on_boundary;
}

}  // namespace posture
