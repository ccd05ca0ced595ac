// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/mesh/edges.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <utility>

namespace posture {

std::vector<Edge> meshEdges(const Faces& faces) {
  std::vector<std::pair<int, int>> sides;
  sides.reserve(3 * faces.rows());
  for (int f = 0; f < faces.rows(); ++f)
    for (int k = 0; k < 3; ++k) sides.push_back(std::minmax(faces(f, k), faces(f, (k + 1) % 3)));
  std::sort(sides.begin(), sides.end());
  std::vector<Edge> edges;
  for (const auto& [a, b] : sides) {
    if (!edges.empty() && edges.back().first == a && edges.back().second == b)
      ++edges.back().faces;
    else
      edges.push_back({a, b, 1});
  }
  return edges;
}

double meanEdgeLength(const TriangleMesh& mesh) {
  double sum = 0;
  const std::vector<Edge> edges = meshEdges(mesh.faces);
  for (const Edge& e : edges)
    sum += (mesh.vertices.row(e.first) - mesh.vertices.row(e.second)).norm();
  return edges.empty() ? 0 : sum / static_cast<double>(edges.size());
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

std::vector<int> vertexFaces(const Faces& faces, int vertex_count) {
  std::vector<int> face_of(vertex_count, -1);
  for (int f = static_cast<int>(faces.rows()) - 1; f >= 0; --f)
    for (int k = 0; k < 3; ++k) face_of[faces(f, k)] = f;
  return face_of;
}

}  // namespace posture
