// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/median.h>
#include <posture/mesh/edges.h>
#include <posture/mesh/seams.h>
#include <posture/mesh/weld.h>

#include <boost/container_hash/hash.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>
#include <utility>
#include <vector>

namespace posture {
namespace {

/// Of the shortest edge at a vertex, and of a typical one at the rims: far more than single
/// precision leaves of meshes of a million vertices, far less than there is between vertices.
constexpr double ROUNDING = 0.01;

/// The first of the points it was given before that is nearer than what each of the two asks.
class FirstNear {
 public:
  /// \param most  of `asked`, what each point asks.
  FirstNear(const Points& points, const std::vector<double>& asked, double most)
      : points_(points), asked_(asked), most_(most) {}

  /// The point itself where there is none.
  int find(int point) {
    const Cell cell = cellOf(point);
    int first = point;
    for (int i = -1; i <= 1; ++i)
      for (int j = -1; j <= 1; ++j)
        for (int k = -1; k <= 1; ++k) {
          const auto found = firsts_.find({cell[0] + i, cell[1] + j, cell[2] + k});
          if (found == firsts_.end()) continue;
          for (int other : found->second)
            if (other < first && areNear(other, point)) first = other;
        }
    if (first == point) firsts_[cell].push_back(point);
    return first;
  }

 private:
  /// Whole numbers, in double precision: they may be larger than integers can be.
  using Cell = std::array<double, 3>;

  bool areNear(int a, int b) const {
    return (points_.row(a) - points_.row(b)).norm() <= std::min(asked_[a], asked_[b]);
  }

  Cell cellOf(int point) const {
    Cell cell{};
    for (int k = 0; k < 3; ++k) cell[k] = std::floor(points_(point, k) / most_) + 0.0;
    return cell;
  }

  const Points& points_;
  const std::vector<double>& asked_;
  const double most_;
  std::unordered_map<Cell, std::vector<int>, boost::hash<Cell>> firsts_;
};

}  // namespace

int closeSeams(TriangleMesh& mesh) {
  const Points& vertices = mesh.vertices;
  const std::vector<int> first = weld(vertices);
  const std::vector<Edge> edges = meshEdges(weldedFaces(mesh.faces, first));
  const auto length = [&](const Edge& e) {
    return (vertices.row(e.first) - vertices.row(e.second)).norm();
  };
  std::vector<char> at_rim(vertices.rows(), 0);
  std::vector<double> lengths;
  for (const Edge& e : edges) {
    if (e.faces > 1) continue;
    at_rim[e.first] = at_rim[e.second] = 1;
    lengths.push_back(length(e));
  }
  if (lengths.empty()) return 0;
  const double most = ROUNDING * median(std::move(lengths));
  if (!(most > 0 && std::isfinite(most))) return 0;
  std::vector<double> asked(vertices.rows(), most);
  for (const Edge& e : edges)
    for (int v : {e.first, e.second}) asked[v] = std::min(asked[v], ROUNDING * length(e));
  FirstNear known(vertices, asked, most);
  std::vector<int> place = first;
  for (int v = 0; v < vertices.rows(); ++v)
    place[v] = first[v] != v ? place[first[v]] : at_rim[v] != 0 ? known.find(v) : v;
  int moved = 0;
  for (int v = 0; v < vertices.rows(); ++v) moved += place[v] != first[v];
  if (moved > 0) mesh.vertices = vertices(place, Eigen::all).eval();
  return moved;
}

}  // namespace posture
