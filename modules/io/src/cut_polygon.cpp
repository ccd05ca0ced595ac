// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/io/cut_polygon.h>

#include <Eigen/Geometry>

#include <algorithm>

namespace posture {
namespace {

using Eigen::Vector3d;

/// What is left of a polygon while ears are taken off.
class Ring {
 public:
  explicit Ring(const Points& corners)
      : before_(corners.rows()), after_(corners.rows()), blocked_(corners.rows()) {
    const int n = static_cast<int>(corners.rows());
    for (int i = 0; i < n; ++i) {
      before_[i] = (i + n - 1) % n;
      after_[i] = (i + 1) % n;
    }
    // At most one large, as products of far ones would overflow.
    const Eigen::RowVector3d origin = corners.row(0);
    const double size = (corners.rowwise() - origin).cwiseAbs().maxCoeff();
    places_ = (corners.rowwise() - origin) / (size > 0 ? size : 1);
    for (int i = 0; i < n; ++i) normal_ += at(i).cross(at(after_[i]));
    normal_.normalize();
    for (int i = 0; i < n; ++i)
      if (!(turn(before_[i], i, after_[i]) > 0)) reflex_.push_back(i);
  }

  int before(int i) const { return before_[i]; }
  int after(int i) const { return after_[i]; }

  /// Whether the corner sticks out, and none of what is left lies in the triangle there.
  bool isEar(int i) {
    const int a = before_[i], c = after_[i];
    if (!(turn(a, i, c) > 0)) return false;
    Blocked& known = blocked_[i];
    if (known.by >= 0 && known.before == a && known.after == c && !isGone(known.by)) return false;
    for (int other : reflex_) {
      if (isGone(other) || isAt(other, a) || isAt(other, i) || isAt(other, c)) continue;
      if (turn(a, i, other) < OUTSIDE || turn(i, c, other) < OUTSIDE || turn(c, a, other) < OUTSIDE)
        continue;
      known = {other, a, c};
      return false;
    }
    return true;
  }

  void remove(int i) {
    after_[before_[i]] = after_[i];
    before_[after_[i]] = before_[i];
  }

 private:
  /// What lies on a side is in the triangle, as rounding has it: places are at most 1.
  static constexpr double OUTSIDE = -1e-14;

  /// What was found in the triangle at a corner between these two.
  struct Blocked {
    int by = -1, before = -1, after = -1;
  };

  Vector3d at(int i) const { return places_.row(i); }

  /// The same corner or one at its place, as where a bridge leads to a hole.
  bool isAt(int i, int j) const { return places_.row(i) == places_.row(j); }

  bool isGone(int i) const { return after_[before_[i]] != i; }

  /// Twice the area of a triangle as seen along the normal; > 0: to the left.
  double turn(int a, int b, int c) const {
    return normal_.dot((at(b) - at(a)).cross(at(c) - at(a)));
  }

  std::vector<int> before_, after_;
  std::vector<Blocked> blocked_;
  Points places_;
  Vector3d normal_ = Vector3d::Zero();
  std::vector<int> reflex_;  // corners that do not stick out at first: only these may be in an ear
};

}  // namespace

std::vector<std::array<int, 3>> cutPolygon(const Points& corners) {
  Ring ring(corners);
  std::vector<std::array<int, 3>> triangles;
  int left = static_cast<int>(corners.rows()), in_vain = 0;
  for (int i = 1; left > 2; i = ring.after(i)) {
    // Where it crosses itself or has no area there may be no ear: any corner will do then.
    if (left > 3 && in_vain < left && !ring.isEar(i)) {
      ++in_vain;
      continue;
    }
    std::array<int, 3> triangle{ring.before(i), i, ring.after(i)};
    std::rotate(
        triangle.begin(), std::min_element(triangle.begin(), triangle.end()), triangle.end());
    triangles.push_back(triangle);
    ring.remove(i);
    --left;
    in_vain = 0;
    i = ring.after(i);
  }
  return triangles;
}

}  // namespace posture
