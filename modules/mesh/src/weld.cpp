// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "weld.h"

#include <posture/core/median.h>
#include <posture/mesh/edges.h>

#include <boost/container_hash/hash.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>
#include <utility>

namespace posture {
namespace {

/// Of the shortest edge at a vertex, and of a typical one at the rims: far more than single
/// precision leaves of meshes of a million vertices, far less than there is between vertices.
constexpr double ROUNDING = 0.01;

std::vector<int> firstAtPlace(const Points& vertices) {
  using Place = std::array<double, 3>;
  std::unordered_map<Place, int, boost::hash<Place>> first_at;
  first_at.reserve(vertices.rows());
  std::vector<int> first(vertices.rows());
  for (int v = 0; v < vertices.rows(); ++v) {
    // Adding zero turns -0 into +0.
    const Place place{vertices(v, 0) + 0.0, vertices(v, 1) + 0.0, vertices(v, 2) + 0.0};
    first[v] = first_at.try_emplace(place, v).first->second;
  }
  return first;
}

/// The first of the points given to it that is nearer than what each of the two asks.
class FirstNear {
 public:
  /// \param most  of `asked`, what each point asks.
  FirstNear(const Points& points, const std::vector<double>& asked, double most)
      : points_(points), asked_(asked), most_(most) {}

  int find(int point) {
    const Cell cell = cellOf(point);
    for (int i = -1; i <= 1; ++i)
      for (int j = -1; j <= 1; ++j)
        for (int k = -1; k <= 1; ++k) {
          const auto found = firsts_.find({cell[0] + i, cell[1] + j, cell[2] + k});
          if (found == firsts_.end()) continue;
          for (int first : found->second)
            if (areNear(first, point)) return first;
        }
    firsts_[cell].push_back(point);
    return point;
  }

 private:
  /// Whole numbers, in double precision: they may be larger than integers can be.
  using Cell = std::array<double, 3>;

  bool areNear(int a, int b) const {
    return (points_.row(a) - points_.row(b)).norm() <= std::min(asked_[a], asked_[b]);
  }

  Cell cellOf(int point) const {
    Cell cell{};
    for (int k = 0; k < 3; ++k) cell[k] = std::round(points_(point, k) / most_) + 0.0;
    return cell;
  }

  const Points& points_;
  const std::vector<double>& asked_;
  const double most_;
  std::unordered_map<Cell, std::vector<int>, boost::hash<Cell>> firsts_;
};

}  // namespace

std::vector<int> weld(const TriangleMesh& mesh) {
  const Points& vertices = mesh.vertices;
  std::vector<int> first = firstAtPlace(vertices);
  const Faces faces = weldedFaces(mesh.faces, first);
  const std::vector<Edge> edges = meshEdges(faces);
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
  if (lengths.empty()) return first;
  const double most = ROUNDING * median(std::move(lengths));
  if (!(most > 0)) return first;
  std::vector<double> asked(vertices.rows(), most);
  for (const Edge& e : edges)
    for (int v : {e.first, e.second}) asked[v] = std::min(asked[v], ROUNDING * length(e));
  FirstNear known(vertices, asked, most);
  for (int v = 0; v < vertices.rows(); ++v)
    first[v] = first[v] != v ? first[first[v]] : at_rim[v] != 0 ? known.find(v) : v;
  return first;
}

Faces weldedFaces(const Faces& faces, const std::vector<int>& first) {
  Faces welded(faces.rows(), 3);
  Eigen::Index count = 0;
  for (Eigen::Index f = 0; f < faces.rows(); ++f) {
    const int a = first[faces(f, 0)], b = first[faces(f, 1)], c = first[faces(f, 2)];
    if (a != b && b != c && c != a) welded.row(count++) << a, b, c;
  }
  welded.conservativeResize(count, 3);
  return welded;
}

}  // namespace posture
