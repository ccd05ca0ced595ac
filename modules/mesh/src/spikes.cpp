// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/median.h>
#include <posture/mesh/spikes.h>
#include <posture/mesh/vertex_neighbors.h>
#include <posture/mesh/weld.h>

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

namespace posture {
namespace {

/// Times the neighbours' distance from their middle. Of 440,000 vertices of bodies and of scans of
/// them eleven have more, up to seven, at the sharpest tips; noise moves the neighbours as well.
constexpr double FAR = 5;

/// Medians, so that neighbours that are spikes do not count.
bool isSpike(const Points& vertices, const VertexNeighbors& neighbors, int v) {
  const int *begin = neighbors.begin(v), *end = neighbors.end(v);
  if (end - begin < 3) return false;
  std::vector<double> values(end - begin);
  Eigen::RowVector3d middle;
  for (int k = 0; k < 3; ++k) {
    std::transform(begin, end, values.begin(), [&](int w) { return vertices(w, k); });
    middle[k] = lowerMedian(values);
  }
  double nearest = std::numeric_limits<double>::infinity();
  for (const int* w = begin; w != end; ++w) {
    values[w - begin] = (vertices.row(*w) - middle).norm();
    nearest = std::min(nearest, (vertices.row(*w) - vertices.row(v)).norm());
  }
  return nearest > FAR * lowerMedian(values);
}

}  // namespace

int setSpikesBack(TriangleMesh& mesh) {
  const int n = static_cast<int>(mesh.vertices.rows());
  const std::vector<int> place = weld(mesh.vertices);
  const VertexNeighbors neighbors(weldedFaces(mesh.faces, place), n);
  std::vector<int> spikes;
  std::vector<char> astray(n, 0);
  for (int v = 0; v < n; ++v)
    if (isSpike(mesh.vertices, neighbors, v)) {
      spikes.push_back(v);
      astray[v] = 1;
    }
  if (spikes.empty()) return 0;
  // From the good ones inwards, where spikes are next to each other.
  std::vector<int> left = spikes;
  for (std::size_t before = left.size() + 1; left.size() < before;) {
    before = left.size();
    std::vector<std::pair<int, Eigen::RowVector3d>> back;
    for (int v : left) {
      Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
      int count = 0;
      for (const int* w = neighbors.begin(v); w != neighbors.end(v); ++w)
        if (!astray[*w]) {
          sum += mesh.vertices.row(*w);
          ++count;
        }
      if (count > 0) back.emplace_back(v, sum / count);
    }
    for (const auto& [v, at] : back) {
      mesh.vertices.row(v) = at;
      astray[v] = 0;
    }
    left.erase(std::remove_if(left.begin(), left.end(), [&](int v) { return !astray[v]; }),
               left.end());
  }
  for (int v = 0; v < n; ++v) mesh.vertices.row(v) = mesh.vertices.row(place[v]);
  return static_cast<int>(spikes.size() - left.size());
}

}  // namespace posture
