// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "surface/doubts.h"

#include <posture/core/parallel.h>
#include <posture/core/shortest_ways.h>
#include <posture/core/unions.h>
#include <posture/mesh/edges.h>
#include <posture/mesh/normals.h>
#include <posture/mesh/vertex_neighbors.h>

#include "points/neighbors.h"
#include <algorithm>
#include <numeric>
#include <set>
#include <vector>

namespace posture {
namespace {

/// Ways along edges, some of them left out.
class EdgeGraph {
 public:
  EdgeGraph(const Points& vertices,
            const std::vector<Edge>& edges,
            const std::vector<char>& left_out)
      : vertices_(vertices), neighbors_(vertices.rows()), ways_(static_cast<int>(vertices.rows())) {
    for (std::size_t e = 0; e < edges.size(); ++e) {
      if (left_out[e]) continue;
      neighbors_[edges[e].first].push_back(edges[e].second);
      neighbors_[edges[e].second].push_back(edges[e].first);
    }
  }

  /// Whether a way from one vertex to another is shorter than `bound`.
  bool hasWay(int from, int to, double bound) {
    ways_.search(
        {from},
        [&](int v, const auto& step) {
          for (int w : neighbors_[v]) step(w, (vertices_.row(v) - vertices_.row(w)).norm());
        },
        [&](int v) { return v != to && ways_.distance(v) < bound; });
    return ways_.distance(to) < bound;
  }

 private:
  const Points& vertices_;
  std::vector<std::vector<int>> neighbors_;
  ShortestWays ways_;
};

}  // namespace

int possibleContacts(const TriangleMesh& mesh, const Points& normals, double spacing) {
  const int n = static_cast<int>(mesh.vertices.rows());
  const std::vector<Edge> edges = meshEdges(mesh.faces);
  std::vector<char> concave(edges.size());
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const auto [i, j, faces] = edges[e];
    const Eigen::RowVector3d offset = mesh.vertices.row(j) - mesh.vertices.row(i);
    concave[e] = (normals.row(i) - normals.row(j)).dot(offset) > 0.3 * offset.norm();
  }
  EdgeGraph graph(mesh.vertices, edges, concave);
  Unions places(n);
  std::vector<int> ends;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    if (!concave[e] || graph.hasWay(edges[e].first, edges[e].second, 20 * spacing)) continue;
    places.join(edges[e].first, edges[e].second);
    ends.push_back(edges[e].first);
  }
  std::set<int> groups;
  for (int v : ends) groups.insert(places.root(v));
  return static_cast<int>(groups.size());
}

double thinShare(const TriangleMesh& mesh, double spacing) {
  const int n = static_cast<int>(mesh.vertices.rows());
  const Points normals = vertexNormals(mesh);
  const NeighborSearch search(mesh.vertices);
  const VertexNeighbors neighbors(mesh.faces, n);
  std::vector<char> is_thin(n, 0);
  forEach(n, [&](int v) {
    const int *begin = neighbors.begin(v), *end = neighbors.end(v);
    double edges = 0;
    for (const int* w = begin; w != end; ++w)
      edges += (mesh.vertices.row(*w) - mesh.vertices.row(v)).norm();
    const double here = std::min(spacing, edges / static_cast<double>(end - begin));
    const std::vector<int> near = search.within(mesh.vertices.row(v), 3 * here);
    is_thin[v] = std::any_of(near.begin(), near.end(), [&](int w) {
      const Eigen::RowVector3d offset = mesh.vertices.row(w) - mesh.vertices.row(v);
      return normals.row(v).dot(normals.row(w)) < -0.5 &&
             normals.row(v).dot(offset) < -0.7 * offset.norm();
    });
  });
  return static_cast<double>(std::count(is_thin.begin(), is_thin.end(), 1)) / n;
}

}  // namespace posture
