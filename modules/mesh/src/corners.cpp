// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/mesh/corners.h>
#include <posture/mesh/weld.h>

#include <algorithm>

namespace posture {

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

int cornerPlaces(const TriangleMesh& mesh, int vertices) {
  const std::vector<int> first = weld(mesh.vertices);
  Faces faces = mesh.faces;
  for (int& v : faces.reshaped()) v = first[v];
  const std::vector<char> is_corner = cornersOfFaces(faces, static_cast<int>(first.size()));
  return static_cast<int>(std::count(is_corner.begin(), is_corner.begin() + vertices, 1));
}

}  // namespace posture
