// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sides/leave_out_background.h"

#include <posture/mesh/background.h>
#include <posture/mesh/weld.h>

#include <algorithm>

namespace posture {

Background leaveOutBackground(TriangleMesh& mesh) {
  const std::vector<char> background = backgroundFaces(mesh);
  Background found;
  found.faces = static_cast<int>(std::count(background.begin(), background.end(), 1));
  if (found.faces == 0) return found;
  found.vertices.assign(mesh.vertices.rows(), 0);
  for (const char of_background : {1, 0})
    for (int f = 0; f < mesh.faces.rows(); ++f)
      if (background[f] == of_background)
        for (int v : mesh.faces.row(f)) found.vertices[v] = of_background;
  // What stands for all vertices at a place of the body is the body's.
  const std::vector<int> first = weld(mesh.vertices);
  std::vector<int> at_body;
  for (int f = 0; f < mesh.faces.rows(); ++f)
    if (background[f] == 0)
      for (int v : mesh.faces.row(f))
        if (found.vertices[first[v]] != 0) {
          found.vertices[first[v]] = 0;
          at_body.push_back(first[v]);
        }
  for (int f = 0; f < mesh.faces.rows(); ++f) {
    if (background[f] == 0) continue;
    // Not one of the body's, if there is another: points in the face go where that goes.
    auto corners = mesh.faces.row(f);
    const auto own =
        std::find_if(corners.begin(), corners.end(), [&](int v) { return found.vertices[v] != 0; });
    const int corner = own != corners.end() ? *own : corners[0];
    corners.setConstant(corner);
  }
  std::vector<char> in_face(mesh.vertices.rows(), 0);
  for (int v : mesh.faces.reshaped()) in_face[v] = 1;
  for (int v : at_body) found.left_over += in_face[v] == 0;
  return found;
}

}  // namespace posture
