// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "body_checks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>
#include <set>
#include <utility>

namespace posture::test {
namespace {

using Vec3 = Eigen::Vector3d;

Vec3 corner(const TriangleMesh& mesh, int face, int i) {
  return mesh.vertices.row(mesh.faces(face, i % 3));
}

int countRoots(std::vector<int> root, const std::vector<std::pair<int, int>>& links) {
  const std::function<int(int)> find = [&](int v) {
    while (root[v] != v) v = root[v] = root[root[v]];
    return v;
  };
  for (const auto& [a, b] : links) root[find(a)] = find(b);
  int count = 0;
  for (int v = 0; v < static_cast<int>(root.size()); ++v) count += find(v) == v;
  return count;
}

/// Does the segment p, p + way cut the triangle?
bool cuts(const Vec3& p, const Vec3& way, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 ab = b - a, ac = c - a, q = way.cross(ac), s = p - a, r = s.cross(ab);
  const double det = ab.dot(q);
  if (det == 0) return false;
  const double u = s.dot(q) / det, v = way.dot(r) / det, t = ac.dot(r) / det;
  return u >= 0 && v >= 0 && u + v <= 1 && t >= 0 && t <= 1;
}

bool cutEachOther(const TriangleMesh& mesh, int f, int g) {
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      if (mesh.faces(f, i) == mesh.faces(g, j)) return false;
  for (int i = 0; i < 3; ++i)
    for (const auto& [a, b] : {std::pair(f, g), std::pair(g, f)}) {
      const Vec3 p = corner(mesh, a, i), way = corner(mesh, a, i + 1) - p;
      if (cuts(p, way, corner(mesh, b, 0), corner(mesh, b, 1), corner(mesh, b, 2))) return true;
    }
  return false;
}

}  // namespace

Topology topologyOf(const TriangleMesh& mesh) {
  Topology topology;
  const int n = static_cast<int>(mesh.vertices.rows());
  std::map<std::pair<int, int>, int> way;  // directed edge -> how many faces run along it
  std::vector<std::pair<int, int>> links;
  std::vector<int> faces_at(n, 0), edges_at(n, 0);
  for (int f = 0; f < mesh.faces.rows(); ++f)
    for (int i = 0; i < 3; ++i) {
      const int a = mesh.faces(f, i), b = mesh.faces(f, (i + 1) % 3);
      if (++way[{a, b}] > 1) topology.manifold = false;
      links.emplace_back(a, b);
      ++faces_at[a];
    }
  std::vector<int> next_on_rim(n, -1);
  int edges = 0, rim_edges = 0;
  for (const auto& [edge, count] : way) {
    const auto [a, b] = edge;
    const bool rim = way.count({b, a}) == 0;
    if (!rim && a > b) continue;
    ++edges;
    ++edges_at[a];
    ++edges_at[b];
    if (!rim) continue;
    ++rim_edges;
    if (next_on_rim[b] >= 0) topology.manifold = false;  // two rims meet in b
    next_on_rim[b] = a;
  }
  // One fan: as many edges as faces inside, one more on a rim.
  for (int v = 0; v < n; ++v)
    if (faces_at[v] == 0 || edges_at[v] != faces_at[v] + (next_on_rim[v] >= 0))
      topology.manifold = false;
  std::vector<int> all(n);
  std::iota(all.begin(), all.end(), 0);
  topology.components = countRoots(all, links);
  std::vector<std::pair<int, int>> rim_links;
  for (int v = 0; v < n; ++v)
    if (next_on_rim[v] >= 0) rim_links.emplace_back(v, next_on_rim[v]);
  topology.rims = countRoots(all, rim_links) - (n - rim_edges);
  topology.euler = n - edges + static_cast<int>(mesh.faces.rows());
  return topology;
}

double volumeOf(const TriangleMesh& mesh) {
  double sum = 0;
  for (int f = 0; f < mesh.faces.rows(); ++f)
    sum += corner(mesh, f, 0).dot(corner(mesh, f, 1).cross(corner(mesh, f, 2))) / 6;
  return sum;
}

double meanEdgeOf(const TriangleMesh& mesh) {
  double sum = 0;
  for (int f = 0; f < mesh.faces.rows(); ++f)
    for (int i = 0; i < 3; ++i) sum += (corner(mesh, f, i + 1) - corner(mesh, f, i)).norm();
  return sum / static_cast<double>(3 * mesh.faces.rows());
}

double smallestAngleOf(const TriangleMesh& mesh) {
  double smallest = 180;
  for (int f = 0; f < mesh.faces.rows(); ++f)
    for (int i = 0; i < 3; ++i) {
      const Vec3 a = corner(mesh, f, i + 1) - corner(mesh, f, i);
      const Vec3 b = corner(mesh, f, i + 2) - corner(mesh, f, i);
      smallest =
          std::min(smallest, std::atan2(a.cross(b).norm(), a.dot(b)) * 180 / 3.14159265358979);
    }
  return smallest;
}

std::vector<double> edgeChangesOf(const ArticulatedBody& body) {
  std::vector<double> changes;
  const TriangleMesh rest{body.rest_position, body.mesh.faces};
  for (int f = 0; f < rest.faces.rows(); ++f)
    for (int i = 0; i < 3; ++i) {
      const double before = (corner(rest, f, i + 1) - corner(rest, f, i)).norm();
      const double now = (corner(body.mesh, f, i + 1) - corner(body.mesh, f, i)).norm();
      changes.push_back(std::abs(now / before - 1));
    }
  std::sort(changes.begin(), changes.end());
  return changes;
}

int countSelfIntersections(const TriangleMesh& mesh) {
  const double size = 2 * meanEdgeOf(mesh);
  std::map<std::array<int, 3>, std::vector<int>> boxes;
  for (int f = 0; f < mesh.faces.rows(); ++f) {
    const Vec3 a = corner(mesh, f, 0), b = corner(mesh, f, 1), c = corner(mesh, f, 2);
    const Eigen::Array3i low = (a.cwiseMin(b).cwiseMin(c) / size).array().floor().cast<int>();
    const Eigen::Array3i high = (a.cwiseMax(b).cwiseMax(c) / size).array().floor().cast<int>();
    for (int x = low[0]; x <= high[0]; ++x)
      for (int y = low[1]; y <= high[1]; ++y)
        for (int z = low[2]; z <= high[2]; ++z) boxes[{x, y, z}].push_back(f);
  }
  std::set<std::pair<int, int>> found;
  for (const auto& [box, faces] : boxes)
    for (int f : faces)
      for (int g : faces)
        if (f < g && cutEachOther(mesh, f, g)) found.insert({f, g});
  return static_cast<int>(found.size());
}

}  // namespace posture::test
