// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/types.h>

#include <vector>

namespace posture {

/// Leaves out the vertices that are no corner of a face: numbers the others anew in `faces`, from 0
/// on, in the order they had.
///
/// \return  of each of them, the vertex it was.
inline std::vector<int> compactVertices(Faces& faces, int vertex_count) {
  std::vector<int> number(vertex_count, -1), kept;
  for (const int v : faces.reshaped()) number[v] = 0;
  for (int v = 0; v < vertex_count; ++v) {
    if (number[v] < 0) continue;
    number[v] = static_cast<int>(kept.size());
    kept.push_back(v);
  }
  for (int& v : faces.reshaped()) v = number[v];
  return kept;
}

/// The same, in the order that the faces name them in.
inline std::vector<int> compactVerticesByUse(Faces& faces, int vertex_count) {
  std::vector<int> number(vertex_count, -1), kept;
  for (Eigen::Index i = 0; i < faces.size(); ++i) {
    int& v = faces.data()[i];
    if (number[v] < 0) {
      number[v] = static_cast<int>(kept.size());
      kept.push_back(v);
    }
    v = number[v];
  }
  return kept;
}

}  // namespace posture
