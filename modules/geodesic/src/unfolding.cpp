// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "unfolding.h"

#include <posture/mesh/edges.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace posture {
namespace {

using Eigen::Vector2d;

/// Lays the apex of a triangle above the base from (0, 0) to (base, 0), given its sides.
Vector2d apexAbove(double base, double left_side, double right_side) {
  const double x = (base * base + left_side * left_side - right_side * right_side) / (2 * base);
  const double y_sq = left_side * left_side - x * x;
  return {x, std::sqrt(std::max(y_sq, 0.0))};
}

class Unfolder {
 public:
  explicit Unfolder(const TriangleMesh& mesh) : mesh_(mesh), across_(facesAcross(mesh.faces)) {}

  void addCorner(int face, int corner, std::vector<UnfoldedTriangle>& out) const {
    const int apex = mesh_.faces(face, corner);
    const int left = mesh_.faces(face, (corner + 1) % 3);
    const int right = mesh_.faces(face, (corner + 2) % 3);
    const double base = length(left, right);
    if (!(base > 0)) return;
    const Vector2d p = apexAbove(base, length(left, apex), length(right, apex));
    const double y = std::max(p.y(), 1e-9 * base);
    out.push_back({apex, left, right, base, p.x(), y});
    const Vector2d to_left = -p, to_right = Vector2d(base, 0) - p;
    if (to_left.dot(to_right) < 0 && p.y() > 1e-6 * base)
      split(face,
            (corner + 1) % 3,
            {{apex, p}, {left, Vector2d(0, 0)}, {right, Vector2d(base, 0)}},
            out);
  }

 private:
  /// A vertex and where it has come to lie.
  struct Spot {
    int vertex;
    Vector2d place;
  };

  struct Corner {
    Spot apex, left, right;
  };

  double length(int a, int b) const {
    return (mesh_.vertices.row(a) - mesh_.vertices.row(b)).norm();
  }

  /// Walks down the strip of faces below the apex until a vertex splits the corner.
  void split(int face, int side, const Corner& c, std::vector<UnfoldedTriangle>& out) const {
    Spot a = c.left, b = c.right;  // the edge the strip has come to
    // The strip is as long as the corner is flat; beyond this many faces it is a sliver.
    constexpr int MAX_FACES = 16;
    for (int step = 0; step < MAX_FACES; ++step) {
      face = across_(face, side);
      if (face < 0) return;
      const int beyond = thirdCorner(face, a.vertex, b.vertex);
      if (beyond < 0) return;
      const Spot d{beyond, below(a, b, beyond)};
      const Vector2d line = d.place - c.apex.place;
      const bool left_acute = line.dot(c.left.place - c.apex.place) > 0;
      const bool right_acute = line.dot(c.right.place - c.apex.place) > 0;
      if (left_acute && right_acute) {
        addTriangle({c.apex, c.left, d}, out);
        addTriangle({c.apex, d, c.right}, out);
        return;
      }
      // Left or right of the section that both allow: on through the edge it leaves by.
      (left_acute ? a : b) = d;
      side = sideBetween(face, a.vertex, b.vertex);
      if (side < 0) return;
    }
  }

  /// The corner of a face that is neither of two others; -1 where it has none.
  int thirdCorner(int face, int a, int b) const {
    for (int k = 0; k < 3; ++k)
      if (mesh_.faces(face, k) != a && mesh_.faces(face, k) != b) return mesh_.faces(face, k);
    return -1;
  }

  /// Lays a vertex below the edge from a to b, seen from the apex.
  Vector2d below(const Spot& a, const Spot& b, int vertex) const {
    const double edge = (b.place - a.place).norm();
    const Vector2d local = apexAbove(edge, length(a.vertex, vertex), length(b.vertex, vertex));
    const Vector2d along = (b.place - a.place) / edge, down(along.y(), -along.x());
    return a.place + local.x() * along + local.y() * down;
  }

  int sideBetween(int face, int a, int b) const {
    for (int k = 0; k < 3; ++k) {
      const int from = mesh_.faces(face, k), to = mesh_.faces(face, (k + 1) % 3);
      if ((from == a && to == b) || (from == b && to == a)) return k;
    }
    return -1;
  }

  static void addTriangle(const Corner& c, std::vector<UnfoldedTriangle>& out) {
    const Vector2d to_right = c.right.place - c.left.place, to_apex = c.apex.place - c.left.place;
    const double base = to_right.norm();
    if (!(base > 0)) return;
    const Vector2d along = to_right / base, up(-along.y(), along.x());
    const double y = up.dot(to_apex);
    if (y > 1e-9 * base)
      out.push_back({c.apex.vertex, c.left.vertex, c.right.vertex, base, along.dot(to_apex), y});
  }

  const TriangleMesh& mesh_;
  Faces across_;
};

}  // namespace

std::vector<UnfoldedTriangle> unfoldedTriangles(const TriangleMesh& mesh) {
  const Unfolder unfolder(mesh);
  std::vector<UnfoldedTriangle> triangles;
  triangles.reserve(4 * mesh.faces.rows());
  for (int f = 0; f < mesh.faces.rows(); ++f)
    for (int k = 0; k < 3; ++k) unfolder.addCorner(f, k, triangles);
  return triangles;
}

}  // namespace posture
