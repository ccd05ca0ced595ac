// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "clean/curvature_flips.h"

#include <posture/mesh/half_edge_mesh.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <deque>
#include <vector>

namespace posture {
namespace {

using Vector3 = Eigen::RowVector3d;

class CurvatureFlips {
 public:
  explicit CurvatureFlips(const TriangleMesh& mesh)
      : vertices_(mesh.vertices),
        half_edges_(mesh.faces, static_cast<int>(mesh.vertices.rows())),
        is_pending_(half_edges_.halfEdgeCount(), 1) {
    for (int h = 0; h < half_edges_.halfEdgeCount(); ++h) pending_.push_back(h);
  }

  Faces run() {
    while (!pending_.empty()) {
      const int h = pending_.front();
      pending_.pop_front();
      is_pending_[h] = 0;
      if (half_edges_.twin(h) < 0 || !half_edges_.canFlip(h) || gain(h) <= LEAST_GAIN) continue;
      half_edges_.flip(h);
      for (int side : {h, half_edges_.twin(h)})
        for (int edge : {HalfEdgeMesh::next(side), HalfEdgeMesh::previous(side)}) add(edge);
    }
    return half_edges_.faces();
  }

 private:
  static constexpr double LEAST_GAIN = 1e-9;  ///< in the working frame: more than rounding

  void add(int h) {
    if (is_pending_[h]) return;
    is_pending_[h] = 1;
    pending_.push_back(h);
  }

  Vector3 at(int v) const { return vertices_.row(v); }

  /// To the last digit the same for each order of the corners: so the sum falls with every turn,
  /// and there is an end.
  Vector3 normal(int a, int b, int c) const {
    while (a > b || a > c) {
      const int first = a;
      a = b, b = c, c = first;
    }
    return (at(b) - at(a)).cross(at(c) - at(a)).normalized();
  }

  /// Next to no area: the angles to such a face mean nothing.
  bool isNeedle(int a, int b, int c) const {
    constexpr double THIN = 1e-3;
    const Vector3 ab = at(b) - at(a), ac = at(c) - at(a);
    const double longest =
        std::max({ab.squaredNorm(), ac.squaredNorm(), (at(c) - at(b)).squaredNorm()});
    return ab.cross(ac).norm() < THIN * longest;
  }

  /// Length of an edge times the angle between the faces on its sides.
  double curvature(int a, int b, const Vector3& left, const Vector3& right) const {
    return (at(b) - at(a)).norm() * std::atan2(left.cross(right).norm(), left.dot(right));
  }

  /// Of the edge of h, between its face and what lies beyond; `own` is the face's normal.
  double rim(int h, const Vector3& own) const {
    const int twin = half_edges_.twin(h);
    if (twin < 0) return 0;
    const int a = half_edges_.origin(h), b = half_edges_.target(h),
              c = half_edges_.origin(HalfEdgeMesh::previous(twin));
    return curvature(a, b, own, normal(b, a, c));
  }

  /// By how much the curvature of the five edges falls when the edge of h is turned; not at all for
  /// new needles.
  double gain(int h) const {
    const int twin = half_edges_.twin(h);
    const int a = half_edges_.origin(h), b = half_edges_.target(h),
              c = half_edges_.origin(HalfEdgeMesh::previous(h)),
              d = half_edges_.origin(HalfEdgeMesh::previous(twin));
    if (isNeedle(a, d, c) || isNeedle(b, c, d)) return 0;
    const Vector3 left = normal(a, b, c), right = normal(b, a, d);
    const Vector3 at_a = normal(a, d, c), at_b = normal(b, c, d);
    const int bc = HalfEdgeMesh::next(h), ca = HalfEdgeMesh::previous(h),
              ad = HalfEdgeMesh::next(twin), db = HalfEdgeMesh::previous(twin);
    return curvature(a, b, left, right) - curvature(c, d, at_a, at_b) + rim(bc, left) -
           rim(bc, at_b) + rim(ca, left) - rim(ca, at_a) + rim(ad, right) - rim(ad, at_a) +
           rim(db, right) - rim(db, at_b);
  }

  const Points& vertices_;
  HalfEdgeMesh half_edges_;
  std::vector<char> is_pending_;
  std::deque<int> pending_;
};

}  // namespace

Faces withLessCurvature(const TriangleMesh& mesh) { return CurvatureFlips(mesh).run(); }

}  // namespace posture
