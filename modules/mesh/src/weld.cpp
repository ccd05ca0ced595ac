// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/mesh/weld.h>

#include <boost/container_hash/hash.hpp>

#include <algorithm>
#include <array>
#include <unordered_map>
#include <unordered_set>

namespace posture {

std::vector<int> weld(const Points& vertices) {
  using Place = std::array<double, 3>;
  std::unordered_map<Place, int, boost::hash<Place>> first_at;
  first_at.reserve(vertices.rows());
  std::vector<int> representative(vertices.rows());
  for (int v = 0; v < vertices.rows(); ++v) {
    // Adding zero turns -0 into +0.
    const Place place{vertices(v, 0) + 0.0, vertices(v, 1) + 0.0, vertices(v, 2) + 0.0};
    representative[v] = first_at.try_emplace(place, v).first->second;
  }
  return representative;
}

WeldedFaces weldFaces(const Faces& faces, const std::vector<int>& first) {
  using Corners = std::array<int, 3>;
  std::unordered_set<Corners, boost::hash<Corners>> seen;
  seen.reserve(faces.rows());
  WeldedFaces welded;
  welded.faces.resize(faces.rows(), 3);
  for (int f = 0; f < faces.rows(); ++f) {
    const int a = first[faces(f, 0)], b = first[faces(f, 1)], c = first[faces(f, 2)];
    if (a == b || b == c || c == a) {
      ++welded.degenerate;
      continue;
    }
    Corners corners{a, b, c};
    std::sort(corners.begin(), corners.end());
    if (!seen.insert(corners).second) {
      ++welded.repeated;
      continue;
    }
    welded.faces.row(static_cast<Eigen::Index>(welded.input_face.size())) << a, b, c;
    welded.input_face.push_back(f);
  }
  welded.faces.conservativeResize(static_cast<Eigen::Index>(welded.input_face.size()), 3);
  return welded;
}

Faces weldedFaces(const Faces& faces, const std::vector<int>& first) {
  return weldFaces(faces, first).faces;
}

}  // namespace posture
