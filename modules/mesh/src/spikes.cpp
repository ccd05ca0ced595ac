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

/// The place of the least sum of distances to some vertices (Weiszfeld 1937), which turns with
/// them, as medians of coordinates do not.
Eigen::RowVector3d geometricMedian(const Points& vertices, const int* begin, const int* end) {
  // About one of them and at most one large, as squares of far ones would overflow.
  const Eigen::RowVector3d origin = vertices.row(*begin);
  double size = 0;
  for (const int* w = begin; w != end; ++w)
    size = std::max(size, (vertices.row(*w) - origin).cwiseAbs().maxCoeff());
  if (!(size > 0)) return origin;
  Eigen::RowVector3d median = Eigen::RowVector3d::Zero();
  for (const int* w = begin; w != end; ++w)
    median += (vertices.row(*w) - origin) / size / static_cast<double>(end - begin);
  // A far one loses four fifths of its say in each round.
  constexpr int MOST_ROUNDS = 100;
  constexpr double AT_REST = 1e-14;
  for (int round = 0; round < MOST_ROUNDS; ++round) {
    Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
    double weights = 0;
    for (const int* w = begin; w != end; ++w) {
      const Eigen::RowVector3d place = (vertices.row(*w) - origin) / size;
      const double distance = (place - median).norm();
      if (!(distance > 0)) return origin + size * median;
      sum += place / distance;
      weights += 1 / distance;
    }
    const Eigen::RowVector3d before = median;
    median = sum / weights;
    if ((median - before).squaredNorm() < AT_REST * AT_REST) break;
  }
  return origin + size * median;
}

/// Medians, so that neighbours that are spikes do not count.
bool isSpike(const Points& vertices, const VertexNeighbors& neighbors, int v) {
  const int *begin = neighbors.begin(v), *end = neighbors.end(v);
  if (end - begin < 3) return false;
  const Eigen::RowVector3d middle = geometricMedian(vertices, begin, end);
  std::vector<double> values(end - begin);
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
