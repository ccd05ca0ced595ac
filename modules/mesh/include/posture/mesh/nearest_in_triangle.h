// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace posture {

/// Scalar products of a triangle's sides from its first corner, ab and ac, and of these with the
/// way from there to a point p.
struct TriangleProducts {
  double ab_ab, ab_ac, ac_ac, ab_ap, ac_ap;
};

/// Barycentric coordinates of the point of a triangle nearest to p, in any dimension (Ericson 2004,
/// section 5.1.5).
inline Eigen::Vector3d nearestInTriangle(const TriangleProducts& of) {
  const double d1 = of.ab_ap, d2 = of.ac_ap, d3 = d1 - of.ab_ab, d4 = d2 - of.ab_ac,
               d5 = d1 - of.ab_ac, d6 = d2 - of.ac_ac;
  if (d1 <= 0 && d2 <= 0) return {1, 0, 0};
  if (d3 >= 0 && d4 <= d3) return {0, 1, 0};
  if (d6 >= 0 && d5 <= d6) return {0, 0, 1};
  const double vc = d1 * d4 - d3 * d2, vb = d5 * d2 - d1 * d6, va = d3 * d6 - d5 * d4;
  const auto share = [](double part, double whole) { return whole > 0 ? part / whole : 0.5; };
  if (vc <= 0 && d1 >= 0 && d3 <= 0) {
    const double t = share(d1, d1 - d3);
    return {1 - t, t, 0};
  }
  if (vb <= 0 && d2 >= 0 && d6 <= 0) {
    const double t = share(d2, d2 - d6);
    return {1 - t, 0, t};
  }
  if (va <= 0 && d4 >= d3 && d5 >= d6) {
    const double t = share(d4 - d3, (d4 - d3) + (d5 - d6));
    return {0, 1 - t, t};
  }
  const double sum = va + vb + vc;
  return {va / sum, vb / sum, vc / sum};
}

/// The same for points of any dimension.
template <class Column>
Eigen::Vector3d nearestInTriangle(const Column& p,
                                  const Column& a,
                                  const Column& b,
                                  const Column& c) {
  const Column ab = b - a, ac = c - a, ap = p - a;
  return nearestInTriangle(
      TriangleProducts{ab.dot(ab), ab.dot(ac), ac.dot(ac), ab.dot(ap), ac.dot(ap)});
}

}  // namespace posture
