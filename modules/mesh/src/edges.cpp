// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/median.h>
#include <posture/mesh/edges.h>
#include <posture/mesh/vertex_neighbors.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
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

double medianEdgeRatio(const TriangleMesh& mesh, const Points& places) {
  std::vector<double> ratios;
  for (const Edge& e : meshEdges(mesh.faces)) {
    const double before = (mesh.vertices.row(e.first) - mesh.vertices.row(e.second)).norm();
    const double after = (places.row(e.first) - places.row(e.second)).norm();
    if (before > 0 && after > 0) ratios.push_back(after / before);
  }
  return ratios.empty() ? 1 : median(std::move(ratios));
}

double scaleWithoutNoise(const TriangleMesh& mesh, const Points& places) {
  constexpr int PASSES = 5;
  const int n = static_cast<int>(places.rows());
  const VertexNeighbors neighbors(mesh.faces, n);
  const auto smoothed = [&](Points at) {
    for (int pass = 0; pass < PASSES; ++pass) {
      const Points before = at;
      for (int v = 0; v < n; ++v) {
        double count = 1;
        for (const int* w = neighbors.begin(v); w != neighbors.end(v); ++w, ++count)
          at.row(v) += before.row(*w);
        at.row(v) /= count;
      }
    }
    return at;
  };
  return medianEdgeRatio({smoothed(mesh.vertices), mesh.faces}, smoothed(places));
}

Vector faceAreas(const TriangleMesh& mesh) {
  Vector areas(mesh.faces.rows());
  for (int f = 0; f < mesh.faces.rows(); ++f) {
    const Eigen::Vector3d a = mesh.vertices.row(mesh.faces(f, 0));
    const Eigen::Vector3d b = mesh.vertices.row(mesh.faces(f, 1));
    const Eigen::Vector3d c = mesh.vertices.row(mesh.faces(f, 2));
    areas[f] = (b - a).cross(c - a).norm() / 2;
  }
  return areas;
}

double surfaceArea(const TriangleMesh& mesh) { return faceAreas(mesh).sum(); }

double rootArea(const TriangleMesh& mesh) { return std::sqrt(surfaceArea(mesh)); }

std::vector<char> cornersOfFaces(const Faces& faces, int vertex_count) {
  std::vector<char> is_corner(vertex_count, 0);
  for (const auto& face : faces.rowwise())
    if (face[0] != face[1] && face[1] != face[2] && face[2] != face[0])
      for (int v : face) is_corner[v] = 1;
  return is_corner;
}

std::vector<int> faceOfEachVertex(const Faces& faces, int vertex_count) {
  std::vector<int> face_of(vertex_count, -1);
  for (int f = static_cast<int>(faces.rows()) - 1; f >= 0; --f)
    for (int k = 0; k < 3; ++k) face_of[faces(f, k)] = f;
  return face_of;
}

}  // namespace posture
