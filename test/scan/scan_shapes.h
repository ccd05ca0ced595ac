// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/point_cloud.h>
#include <posture/core/rng.h>

#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace posture::test {

inline PointCloud cloudOf(Points points) {
  PointCloud cloud;
  cloud.points = std::move(points);
  return cloud;
}

/// Random points of the unit sphere, moved along its normals by noise.
inline Points spherePoints(int count, double noise, std::uint64_t seed = 1) {
  Rng rng(seed);
  Points points(count, 3);
  for (int i = 0; i < count; ++i) {
    const Eigen::RowVector3d direction(rng.normal(), rng.normal(), rng.normal());
    points.row(i) = (1 + noise * rng.normal()) * direction.normalized();
  }
  return points;
}

/// Random points of [0, 1] x [0, 1] at height z, none in the circle of radius `hole` in its middle.
inline Points planePoints(int count, double z, double hole = 0, std::uint64_t seed = 1) {
  Rng rng(seed);
  Points points(count, 3);
  for (int i = 0; i < count;) {
    points.row(i) << rng.uniform(), rng.uniform(), z;
    if ((points.row(i).head(2).array() - 0.5).matrix().norm() >= hole) ++i;
  }
  return points;
}

/// Random points of a torus around the z axis.
inline Points torusPoints(int count, double large, double small) {
  Rng rng(3);
  Points points(count, 3);
  for (int i = 0; i < count;) {
    const double u = 2 * M_PI * rng.uniform(), v = 2 * M_PI * rng.uniform();
    const double distance = large + small * std::cos(v);
    if (rng.uniform() > distance / (large + small)) continue;
    points.row(i++) << distance * std::cos(u), distance * std::sin(u), small * std::sin(v);
  }
  return points;
}

/// Random points of an upright closed tube of the given radius and length, its axis through (x, 0).
inline Points tubePoints(int count, double x, double radius, double length, std::uint64_t seed) {
  Rng rng(seed);
  Points points(count, 3);
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * M_PI * rng.uniform();
    points.row(i) << x + radius * std::cos(angle), radius * std::sin(angle), length * rng.uniform();
  }
  return points;
}

inline Points joined(const Points& a, const Points& b) {
  Points both(a.rows() + b.rows(), 3);
  both << a, b;
  return both;
}

/// Rings of `around` points about the z axis, much farther apart than the points of a ring, as
/// limbs of coarse meshes have them; both ends closed by a point.
inline Points coarseLimb(int around, int rings, double radius, double step) {
  Points points(around * rings + 2, 3);
  for (int i = 0; i < around * rings; ++i) {
    const double angle = 2 * M_PI * (i % around + 0.5 * (i / around % 2)) / around;
    points.row(i) << radius * std::cos(angle), radius * std::sin(angle), step * (i / around);
  }
  points.row(around * rings) << 0, 0, -0.4 * radius;
  points.row(around * rings + 1) << 0, 0, step * (rings - 1) + 0.4 * radius;
  return points;
}

/// With a ball beside them: coarse points alone do not tell that they have no noise.
inline Points withBall(const Points& points) {
  Points ball = spherePoints(600, 0);
  ball.col(0).array() += 4;
  return joined(points, ball);
}

}  // namespace posture::test
