// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "noisy/agreement.h"

#include <posture/core/parallel.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace posture {
namespace {

double circumradius(const Points& points, const std::array<int, 3>& t) {
  const Eigen::RowVector3d a = points.row(t[1]) - points.row(t[0]),
                           b = points.row(t[2]) - points.row(t[0]);
  const double twice_area = a.cross(b).norm();
  return twice_area > 0 ? a.norm() * b.norm() * (a - b).norm() / (2 * twice_area)
                        : std::numeric_limits<double>::infinity();
}

/// What an accepted triangle takes up around one of its corners, in the tangent plane there.
struct Wedge {
  int from, to;
  double start, extent;  ///< angles
};

/// Accepted triangles, by corners.
class Fans {
 public:
  Fans(const OrientedPoints& oriented, const std::vector<TangentTriangle>& candidates)
      : points_(oriented.points), normals_(oriented.normals) {
    const int n = static_cast<int>(points_.rows());
    first_.assign(n + 1, 0);
    for (const TangentTriangle& c : candidates)
      for (int v : c.corners) ++first_[v + 1];
    for (int v = 0; v < n; ++v) first_[v + 1] += first_[v];
    last_.assign(first_.begin(), first_.end() - 1);
    wedges_.resize(first_[n]);
    axes_.resize(n, 3);
    forEach(n, [&](int v) { axes_.row(v) = normals_.row(v).unitOrthogonal(); });
  }

  /// Whether the triangle fits; if so it is added.
  bool add(const std::array<int, 3>& t) {
    const Eigen::RowVector3d normal = faceNormal(t[0], t[1], t[2]);
    std::array<Wedge, 3> wedges;
    for (int k = 0; k < 3; ++k) {
      const int from = t[(k + 1) % 3], to = t[(k + 2) % 3];
      if (folds(from, t[k], normal) || !wedge(t[k], from, to, wedges[k])) return false;
    }
    for (int k = 0; k < 3; ++k) wedges_[last_[t[k]]++] = wedges[k];
    return true;
  }

 private:
  Eigen::RowVector3d faceNormal(int a, int b, int c) const {
    return (points_.row(b) - points_.row(a)).cross(points_.row(c) - points_.row(a)).normalized();
  }

  /// Whether a triangle already lies beyond the edge, folded back.
  bool folds(int a, int b, const Eigen::RowVector3d& normal) const {
    constexpr double FOLDED_BACK = -0.2;  // cosine: by more than 101 degrees
    for (int w = first_[a]; w < last_[a]; ++w)
      if (wedges_[w].from == b) return faceNormal(a, b, wedges_[w].to).dot(normal) < FOLDED_BACK;
    return false;
  }

  double angle(int v, int to) const {
    const Eigen::RowVector3d d = points_.row(to) - points_.row(v), u = axes_.row(v);
    return std::atan2(normals_.row(v).cross(u).dot(d), u.dot(d));
  }

  /// False when the place is taken.
  bool wedge(int v, int from, int to, Wedge& wedge) const {
    constexpr double ROUNDING = 1e-6;
    wedge = {from, to, angle(v, from), 0};
    wedge.extent = turn(wedge.start, angle(v, to));
    if (wedge.extent >= M_PI) return false;
    for (int w = first_[v]; w < last_[v]; ++w) {
      const Wedge& other = wedges_[w];
      if (other.from == from || other.to == to) return false;
      const double between = turn(wedge.start, other.start);
      if (between < wedge.extent - ROUNDING || between + other.extent > 2 * M_PI + ROUNDING)
        return false;
    }
    return true;
  }

  /// From one angle to another, in [0, 2 pi).
  static double turn(double from, double to) {
    const double difference = to - from;
    return difference < 0 ? difference + 2 * M_PI : difference;
  }

  const Points& points_;
  const Points& normals_;
  Points axes_;
  std::vector<int> first_, last_;
  std::vector<Wedge> wedges_;
};

}  // namespace

Faces agreeingFaces(const OrientedPoints& oriented, std::vector<TangentTriangle> candidates) {
  const int count = static_cast<int>(candidates.size());
  struct Ranked {
    int votes;
    double radius;
    int number;
  };
  std::vector<Ranked> order(count);
  forEach(count, [&](int c) {
    order[c] = {candidates[c].votes, circumradius(oriented.points, candidates[c].corners), c};
  });
  std::sort(order.begin(), order.end(), [](const Ranked& a, const Ranked& b) {
    return std::tie(b.votes, a.radius, a.number) < std::tie(a.votes, b.radius, b.number);
  });
  Fans fans(oriented, candidates);
  std::vector<char> accepted(count, 0);
  for (const Ranked& r : order) accepted[r.number] = fans.add(candidates[r.number].corners);
  Faces faces(std::count(accepted.begin(), accepted.end(), 1), 3);
  for (int c = 0, row = 0; c < count; ++c)
    if (accepted[c])
      faces.row(row++) << candidates[c].corners[0], candidates[c].corners[1],
          candidates[c].corners[2];
  return faces;
}

}  // namespace posture
