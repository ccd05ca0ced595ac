// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_defects.h"

#include <posture/core/compact_vertices.h>
#include <posture/core/error.h>
#include <posture/core/shortest_ways.h>
#include <posture/core/unions.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <limits>
#include <string>
#include <utility>

namespace posture::synthesis {
namespace {

constexpr double FAR = std::numeric_limits<double>::infinity();
constexpr int CANDIDATES = 12;  // the one farthest from the holes so far is cut
constexpr int MAX_FAILURES = 200;

class Puncher {
 public:
  explicit Puncher(const TriangleMesh& mesh)
      : mesh_(mesh), faces_of_(mesh.vertices.rows()), gone_(mesh.faces.rows(), false) {
    for (int f = 0; f < mesh.faces.rows(); ++f)
      for (int i = 0; i < 3; ++i) faces_of_[mesh.faces(f, i)].push_back(f);
  }

  /// Tries to cut one hole around a vertex; leaves everything as it was where that would reach
  /// another hole, or cut off a piece.
  bool punch(int center, double radius) {
    const std::vector<int> disc = facesNear(center, radius);
    for (int f : disc)
      for (int i = 0; i < 3; ++i)
        if (onRim(mesh_.faces(f, i))) return false;
    std::vector<bool> before = gone_;
    for (int f : disc) gone_[f] = true;
    ++holes_;
    if (isManifold(disc) && isOnePieceWithHoles()) return true;
    gone_ = std::move(before);
    --holes_;
    return false;
  }

  PunchedMesh result() const {
    std::vector<int> left;
    for (int f = 0; f < mesh_.faces.rows(); ++f)
      if (!gone_[f]) left.push_back(f);
    PunchedMesh out{mesh_.faces(left, Eigen::all), {}};
    out.survivor = compactVertices(out.faces, static_cast<int>(faces_of_.size()));
    return out;
  }

 private:
  /// Faces whose corners are on average within `radius` of the centre along edges.
  std::vector<int> facesNear(int center, double radius) const {
    ShortestWays ways(static_cast<int>(faces_of_.size()));
    ways.search(
        {center},
        [&](int v, const auto& step) {
          for (int f : faces_of_[v])
            for (int w : mesh_.faces.row(f))
              step(w, (mesh_.vertices.row(v) - mesh_.vertices.row(w)).norm());
        },
        [&](int v) { return ways.distance(v) < radius; });
    std::vector<int> near;
    int nearest = -1;
    double nearest_distance = FAR;
    for (int f = 0; f < mesh_.faces.rows(); ++f) {
      const double d = (ways.distance(mesh_.faces(f, 0)) + ways.distance(mesh_.faces(f, 1)) +
                        ways.distance(mesh_.faces(f, 2))) /
                       3;
      if (d < radius) near.push_back(f);
      if (d < nearest_distance) nearest_distance = d, nearest = f;
    }
    if (near.empty()) near.push_back(nearest >= 0 ? nearest : faces_of_[center][0]);
    return near;
  }

  int countLeft(int v) const {
    return static_cast<int>(
        std::count_if(faces_of_[v].begin(), faces_of_[v].end(), [&](int f) { return !gone_[f]; }));
  }

  bool onRim(int v) const { return countLeft(v) < static_cast<int>(faces_of_[v].size()); }

  /// At each corner of the disc the faces that are left follow each other around it in one fan.
  bool isManifold(const std::vector<int>& disc) const {
    for (int f : disc)
      for (int i = 0; i < 3; ++i)
        if (fansAt(mesh_.faces(f, i)) > 1) return false;
    return true;
  }

  /// The number of gaps around v: a face that is left whose next one is not ends a fan.
  int fansAt(int v) const {
    int fans = 0;
    for (int f : faces_of_[v]) {
      if (gone_[f]) continue;
      const int towards = corner(f, v, 2);
      for (int g : faces_of_[v])
        if (gone_[g] && corner(g, v, 1) == towards) ++fans;
    }
    return fans;
  }

  /// The corner `steps` after v around the face.
  int corner(int f, int v, int steps) const {
    for (int i = 0; i < 3; ++i)
      if (mesh_.faces(f, i) == v) return mesh_.faces(f, (i + steps) % 3);
    return -1;
  }

  /// One component, most of the body, and Euler's number is that of a sphere with holes_ discs cut
  /// out: 2 - holes.
  bool isOnePieceWithHoles() const {
    const int n = static_cast<int>(faces_of_.size());
    Unions joined(n);
    long vertices = 0, half_edges = 0, rim_edges = 0, faces = 0, pieces = 0;
    for (int f = 0; f < mesh_.faces.rows(); ++f) {
      if (gone_[f]) continue;
      ++faces;
      half_edges += 3;
      for (int i = 0; i < 3; ++i) {
        const int a = mesh_.faces(f, i), b = mesh_.faces(f, (i + 1) % 3);
        joined.join(a, b);
        for (int g : faces_of_[b])
          if (gone_[g] && corner(g, b, 1) == a) ++rim_edges;
      }
    }
    for (int v = 0; v < n; ++v) {
      if (countLeft(v) == 0) continue;
      ++vertices;
      pieces += joined.root(v) == v;
    }
    const long edges = (half_edges + rim_edges) / 2;
    const bool body_left = 2 * faces >= mesh_.faces.rows();
    return pieces == 1 && body_left && vertices - edges + faces == 2 - holes_;
  }

  const TriangleMesh& mesh_;
  std::vector<std::vector<int>> faces_of_;
  std::vector<bool> gone_;
  int holes_ = 0;
};

}  // namespace

PunchedMesh punchHoles(const TriangleMesh& mesh, int holes, double radius, Rng& rng) {
  Puncher puncher(mesh);
  const int n = static_cast<int>(mesh.vertices.rows());
  std::vector<double> gap(n, FAR);  // to the nearest centre
  int cut = 0, failures = 0;
  while (cut < holes) {
    int best = rng.below(n);
    for (int i = 1; i < CANDIDATES; ++i) {
      const int other = rng.below(n);
      if (gap[other] > gap[best]) best = other;
    }
    if (!puncher.punch(best, radius)) {
      require(++failures < MAX_FAILURES,
              std::to_string(holes) + " holes of radius " + std::to_string(radius) + ": only " +
                  std::to_string(cut) + " fit and leave the body in one piece");
      continue;
    }
    ++cut;
    for (int v = 0; v < n; ++v)
      gap[v] = std::min(gap[v], (mesh.vertices.row(v) - mesh.vertices.row(best)).norm());
  }
  return puncher.result();
}

void addNoise(TriangleMesh& mesh, double deviation, Rng& rng) {
  Points normals = Points::Zero(mesh.vertices.rows(), 3);
  for (int f = 0; f < mesh.faces.rows(); ++f) {
    const Eigen::RowVector3d a = mesh.vertices.row(mesh.faces(f, 0)),
                             b = mesh.vertices.row(mesh.faces(f, 1)),
                             c = mesh.vertices.row(mesh.faces(f, 2));
    for (int i = 0; i < 3; ++i) normals.row(mesh.faces(f, i)) += (b - a).cross(c - a);
  }
  for (int v = 0; v < mesh.vertices.rows(); ++v)
    mesh.vertices.row(v) += deviation * rng.normal() * normals.row(v).normalized();
}

}  // namespace posture::synthesis
