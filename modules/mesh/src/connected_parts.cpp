// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/unions.h>
#include <posture/mesh/areas.h>
#include <posture/mesh/connected_parts.h>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace posture {

ConnectedParts connectedParts(const TriangleMesh& mesh) {
  const int n = static_cast<int>(mesh.vertices.rows()), m = static_cast<int>(mesh.faces.rows());
  std::vector<int> number(n, -1);
  const std::vector<int> least = leastOfPart(mesh.faces, n);
  const Vector areas = faceAreas(mesh);
  ConnectedParts parts;
  for (int f = 0; f < m; ++f) {
    int& part = number[least[mesh.faces(f, 0)]];
    if (part < 0) {
      part = static_cast<int>(parts.area.size());
      parts.area.push_back(0);
    }
    parts.of_face.push_back(part);
    parts.area[part] += areas[f];
  }
  if (m > 0)
    parts.largest = static_cast<int>(std::max_element(parts.area.begin(), parts.area.end()) -
                                     parts.area.begin());
  return parts;
}

std::vector<int> leastOfPart(const Faces& faces, int vertex_count) {
  Unions sets(vertex_count);
  for (int f = 0; f < faces.rows(); ++f) {
    sets.join(faces(f, 0), faces(f, 1));
    sets.join(faces(f, 0), faces(f, 2));
  }
  return sets.roots();
}

std::vector<std::vector<int>> markedParts(const VertexNeighbors& neighbors,
                                          std::vector<char> marked) {
  std::vector<std::vector<int>> parts;
  for (int start = 0; start < static_cast<int>(marked.size()); ++start) {
    if (marked[start] == 0) continue;
    std::vector<int> part{start};
    marked[start] = 0;
    for (std::size_t i = 0; i < part.size(); ++i)
      for (const int* w = neighbors.begin(part[i]); w != neighbors.end(part[i]); ++w)
        if (marked[*w] != 0) {
          marked[*w] = 0;
          part.push_back(*w);
        }
    parts.push_back(std::move(part));
  }
  return parts;
}

}  // namespace posture
