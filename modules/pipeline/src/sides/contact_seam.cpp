// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sides/contact_seam.h"

#include <posture/mesh/edges.h>
#include <posture/mesh/minimum_cut.h>
#include <posture/mesh/normals.h>

#include <cmath>
#include <limits>
#include <set>
#include <utility>

namespace posture {
namespace {

/// Radians by which a surface folds inwards from one side of an edge to the other that make a path
/// along it e times cheaper. Contacts of scans then cost 0.01 to 0.45 of the narrowest ring.
constexpr double CLEAR_FOLD = 0.35;

/// An edge between two faces, as the first of them runs along it.
struct Between {
  int face, beyond;
  int a, b;
  double cost;  ///< its length, less where the surface folds inwards, more where outwards
};

std::vector<Between> edgesBetween(const TriangleMesh& mesh) {
  const Points normals = vertexNormals(mesh);
  const Faces across = facesAcross(mesh.faces);
  std::vector<Between> edges;
  for (int f = 0; f < mesh.faces.rows(); ++f)
    for (int k = 0; k < 3; ++k) {
      const int there = across(f, k);
      if (there <= f) continue;
      const int a = mesh.faces(f, k), b = mesh.faces(f, (k + 1) % 3),
                here_third = mesh.faces(f, (k + 2) % 3),
                there_third = mesh.faces.row(there).sum() - a - b;
      const Eigen::RowVector3d way =
          (mesh.vertices.row(there_third) - mesh.vertices.row(here_third)).normalized();
      const double fold = (normals.row(here_third) - normals.row(there_third)).dot(way);
      const double length = (mesh.vertices.row(a) - mesh.vertices.row(b)).norm();
      edges.push_back({f, there, a, b, length * std::exp(-fold / CLEAR_FOLD)});
    }
  return edges;
}

/// The steps of a closed path. There and back again is none, nor is staying.
std::set<std::pair<int, int>> stepsAlong(const std::vector<int>& ring) {
  std::set<std::pair<int, int>> steps;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const int from = ring[i], to = ring[(i + 1) % ring.size()];
    if (from != to && steps.erase({to, from}) == 0) steps.insert({from, to});
  }
  return steps;
}

}  // namespace

std::vector<std::pair<int, int>> contactSeam(const TriangleMesh& surface,
                                             const std::vector<int>& ring) {
  constexpr double ANY = std::numeric_limits<float>::max();
  const std::set<std::pair<int, int>> steps = stepsAlong(ring);
  const std::vector<Between> edges = edgesBetween(surface);
  const auto isAlong = [&](int a, int b) { return steps.count({a, b}) > 0; };
  // A closed path between the faces to the left of the ring and those to its right can take the
  // ring's place.
  MinimumCut cut(static_cast<int>(surface.faces.rows()));
  double of_ring = 0;
  for (const Between& edge : edges) {
    const bool left = isAlong(edge.a, edge.b), right = isAlong(edge.b, edge.a);
    if (!left && !right) {
      cut.join(edge.face, edge.beyond, edge.cost);
      continue;
    }
    of_ring += edge.cost;
    cut.joinSource(left ? edge.face : edge.beyond, ANY);
    cut.joinSink(left ? edge.beyond : edge.face, ANY);
  }
  const std::vector<char> beyond = cut.onSinkSide();
  std::vector<std::pair<int, int>> seam;
  double of_seam = 0;
  for (const Between& edge : edges) {
    if (beyond[edge.face] == beyond[edge.beyond]) continue;
    if (isAlong(edge.a, edge.b) || isAlong(edge.b, edge.a)) continue;
    of_seam += edge.cost;
    seam.emplace_back(edge.a, edge.b);
  }
  if (seam.empty() || of_seam >= of_ring) return {steps.begin(), steps.end()};
  return seam;
}

}  // namespace posture
