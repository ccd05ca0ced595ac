// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/median.h>
#include <posture/mesh/spikes.h>
#include <posture/mesh/vertex_neighbors.h>
#include <posture/mesh/weld.h>

#include <algorithm>
#include <iterator>
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
  Eigen::RowVector3d origin = vertices.row(*begin);
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

/// Of the edges of the neighbours but those to the vertex.
double typicalEdgeAround(const Points& vertices, const VertexNeighbors& neighbors, int v) {
  std::vector<double> typical;
  for (const int* w = neighbors.begin(v); w != neighbors.end(v); ++w) {
    std::vector<double> lengths;
    for (const int* u = neighbors.begin(*w); u != neighbors.end(*w); ++u)
      if (*u != v) lengths.push_back((vertices.row(*u) - vertices.row(*w)).norm());
    if (!lengths.empty()) typical.push_back(median(std::move(lengths)));
  }
  return typical.empty() ? std::numeric_limits<double>::infinity() : lowerMedian(typical);
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
  // Where faces are needles, two neighbours may be close together by chance.
  return nearest > FAR * lowerMedian(values) &&
         nearest > FAR * typicalEdgeAround(vertices, neighbors, v);
}

/// Vertices with the spikes among them set back, from the good ones inwards where spikes are next
/// to each other. \param left  how many stay where they are, among spikes alone.
Points withSetBack(Points vertices,
                   const VertexNeighbors& neighbors,
                   std::vector<char> astray,
                   int& left) {
  std::vector<int> spikes;
  for (int v = 0; v < vertices.rows(); ++v)
    if (astray[v] != 0) spikes.push_back(v);
  for (std::size_t before = spikes.size() + 1; spikes.size() < before;) {
    before = spikes.size();
    std::vector<std::pair<int, Eigen::RowVector3d>> back;
    for (int v : spikes) {
      // The median, as one among them may be a spike that is not told yet.
      std::vector<int> good;
      std::copy_if(neighbors.begin(v), neighbors.end(v), std::back_inserter(good), [&](int w) {
        return astray[w] == 0;
      });
      if (!good.empty())
        back.emplace_back(v, geometricMedian(vertices, good.data(), good.data() + good.size()));
    }
    for (const auto& [v, at] : back) {
      vertices.row(v) = at;
      astray[v] = 0;
    }
    spikes.erase(std::remove_if(spikes.begin(), spikes.end(), [&](int v) { return !astray[v]; }),
                 spikes.end());
  }
  left = static_cast<int>(spikes.size());
  return vertices;
}

}  // namespace

int setSpikesBack(TriangleMesh& mesh) {
  const int n = static_cast<int>(mesh.vertices.rows());
  const std::vector<int> place = weld(mesh.vertices);
  const VertexNeighbors neighbors(weldedFaces(mesh.faces, place), n);
  // Where many neighbours are spikes as well one is told only when these are back.
  constexpr int MOST_ROUNDS = 10;
  Points vertices = mesh.vertices;
  std::vector<char> is_spike(n, 0);
  int spikes = 0, left = 0;
  for (int round = 0; round < MOST_ROUNDS; ++round) {
    const int before = spikes;
    for (int v = 0; v < n; ++v)
      if (is_spike[v] == 0 && isSpike(vertices, neighbors, v)) {
        is_spike[v] = 1;
        ++spikes;
      }
    if (spikes == before) break;
    vertices = withSetBack(mesh.vertices, neighbors, is_spike, left);
  }
  if (spikes > 0) mesh.vertices = vertices(place, Eigen::all);
  return spikes - left;
}

}  // namespace posture
