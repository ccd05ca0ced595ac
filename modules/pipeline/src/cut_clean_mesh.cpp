// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cut_clean_mesh.h"

#include <posture/core/error.h>

#include <algorithm>

namespace posture {

TriangleMesh withoutVertices(const TriangleMesh& input,
                             const CleanMesh& clean,
                             const std::vector<int>& vertices) {
  std::vector<char> gone(clean.mesh.vertices.rows(), 0);
  for (int v : vertices) gone[v] = 1;
  const Faces faces = facedAlike(input.faces, clean);
  TriangleMesh cut{input.vertices, Faces(faces.rows(), 3)};
  Eigen::Index kept = 0;
  for (int f = 0; f < faces.rows(); ++f) {
    const Eigen::RowVector3i face = faces.row(f);
    const bool touches = std::any_of(face.data(), face.data() + 3, [&](int v) {
      return clean.offset[v] == 0 && gone[clean.clean_vertex[v]];
    });
    if (!touches) cut.faces.row(kept++) = face;
  }
  cut.faces.conservativeResize(kept, 3);
  return cut;
}

std::optional<CleanMesh> cleanRest(const TriangleMesh& cut) {
  try {
    return cleanMesh(cut, Facing::AS_MOST);
  } catch (const InputError&) {
    return std::nullopt;
  }
}

}  // namespace posture
