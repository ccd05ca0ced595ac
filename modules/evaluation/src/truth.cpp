// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/error.h>
#include <posture/evaluation/truth.h>
#include <posture/io/correspondence_io.h>

#include <algorithm>
#include <cmath>

namespace posture {
namespace {

void checkVertex(const std::string& name, const char* side, int vertex, int count) {
  if (vertex >= 0 && vertex < count) return;
  throw InputError(name + ": " + side + " vertex " + std::to_string(vertex) + ", but there are " +
                   std::to_string(count));
}

}  // namespace

std::vector<VertexPair> readTruth(const std::filesystem::path& truth,
                                  int source_vertices,
                                  int target_vertices) {
  std::vector<VertexPair> pairs;
  if (truth == "identity") {
    if (source_vertices != target_vertices)
      throw InputError(
          "identity: the shapes are not numbered alike: " + std::to_string(source_vertices) +
          " source vertices, " + std::to_string(target_vertices) + " on the target");
    for (int v = 0; v < source_vertices; ++v) pairs.push_back({v, v});
    return pairs;
  }
  pairs = readVertexPairs(truth);
  for (const VertexPair& pair : pairs) {
    checkVertex(truth.string(), "source", pair.source, source_vertices);
    checkVertex(truth.string(), "target", pair.target, target_vertices);
  }
  return pairs;
}

void checkOnTarget(const std::string& name,
                   const std::vector<SurfacePoint>& on_target,
                   const TriangleMesh& target) {
  const auto isAt = [&](int v, int w) {  // meshes may have several vertices at one place
    return v == w || target.vertices.row(v) == target.vertices.row(w);
  };
  for (std::size_t row = 0; row < on_target.size(); ++row) {
    const SurfacePoint& place = on_target[row];
    if (place.vertex < 0) continue;
    const std::string where = name + ": row " + std::to_string(row);
    checkVertex(where, "target", place.vertex, static_cast<int>(target.vertices.rows()));
    if (place.face < 0) continue;
    const std::string face = where + ": face " + std::to_string(place.face);
    if (place.face >= target.faces.rows())
      throw InputError(face + ", but the target has " + std::to_string(target.faces.rows()));
    if (!(place.barycentric.minCoeff() >= -1e-6 && std::abs(place.barycentric.sum() - 1) <= 1e-3))
      throw InputError(where + ": barycentric coordinates that are negative or do not sum to 1");
    const auto corners = target.faces.row(place.face);
    if (std::none_of(corners.begin(), corners.end(), [&](int v) { return isAt(v, place.vertex); }))
      throw InputError(face + " does not have the target vertex " + std::to_string(place.vertex));
  }
}

}  // namespace posture
