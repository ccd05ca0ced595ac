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
      split(face, (corner + 1) % 3, {apex, left, right}, p, base, out);
  }

 private:
  double length(int a, int b) const {
    return (mesh_.vertices.row(a) - mesh_.vertices.row(b)).norm();
  }

  struct Corner {
    int apex, left, right;
  };

  /// Walks down the strip of faces below the apex until a vertex splits the corner.
  void split(int face,
             int side,
             Corner c,
             const Vector2d& p,
             double base,
             std::vector<UnfoldedTriangle>& out) const {
    const Vector2d far_left(0, 0), far_right(base, 0);
    Vector2d a = far_left, b = far_right;  // the edge the strip has come to
    int va = c.left, vb = c.right;
    // The strip is as long as the corner is flat; beyond this many faces it is a sliver.
    constexpr int MAX_FACES = 16;
    for (int step = 0; step < MAX_FACES; ++step) {
      const int beyond = across_(face, side);
      if (beyond < 0) return;
      int k = 0;
      while (mesh_.faces(beyond, k) == va || mesh_.faces(beyond, k) == vb) ++k;
      if (k > 2) return;
      const int vd = mesh_.faces(beyond, k);
      // Below the edge a b, seen from the apex.
      const double edge = (b - a).norm();
      const Vector2d local = apexAbove(edge, length(va, vd), length(vb, vd));
      const Vector2d along = (b - a) / edge, down(along.y(), -along.x());
      const Vector2d d = a + local.x() * along + local.y() * down;
      const Vector2d line = d - p;
      const bool left_acute = line.dot(far_left - p) > 0, right_acute = line.dot(far_right - p) > 0;
      if (left_acute && right_acute) {
        addTriangle(c.apex, c.left, vd, p, far_left, d, out);
        addTriangle(c.apex, vd, c.right, p, d, far_right, out);
        return;
      }
      // Left or right of the section that both allow: on through the edge it leaves by.
      face = beyond;
      if (left_acute) {
        a = d;
        va = vd;
      } else {
        b = d;
        vb = vd;
      }
      side = sideBetween(face, va, vb);
      if (side < 0) return;
    }
  }

  int sideBetween(int face, int a, int b) const {
    for (int k = 0; k < 3; ++k) {
      const int from = mesh_.faces(face, k), to = mesh_.faces(face, (k + 1) % 3);
      if ((from == a && to == b) || (from == b && to == a)) return k;
    }
    return -1;
  }

  static void addTriangle(int apex,
                          int left,
                          int right,
                          const Vector2d& p,
                          const Vector2d& l,
                          const Vector2d& r,
                          std::vector<UnfoldedTriangle>& out) {
    const double base = (r - l).norm();
    if (!(base > 0)) return;
    const Vector2d along = (r - l) / base, up(-along.y(), along.x());
    const double y = up.dot(p - l);
    if (y > 1e-9 * base) out.push_back({apex, left, right, base, along.dot(p - l), y});
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
