// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "field.h"

#include <algorithm>
#include <cmath>

namespace posture::synthesis {
namespace {

constexpr double WARP = 0.0045;  // amplitude of each wave, body units

constexpr double DETAIL_REACH = 0.02;    // how far around a part its edge length is heeded
constexpr double EDGE_PER_RADIUS = 1.2;  // five edges or more around every limb

/// Minimum of two distances, rounded off where they differ by less than `blend`.
double smoothMin(double a, double b, double blend) {
  const double h = std::max(blend - std::abs(a - b), 0.0) / blend;
  return std::min(a, b) - h * h * h * blend / 6;
}

/// Three slow waves across directions without symmetry.
Vec3 warped(const Vec3& p) {
  static const Vec3 WAYS[3] = {{.8, .3, -.5}, {-.4, .5, .75}, {.5, -.8, .35}};
  return p + WARP * (std::sin(7.0 * p.x() + 9.0 * p.y() - 5.0 * p.z() + 0.4) * WAYS[0] +
                     std::sin(-9.0 * p.x() + 6.0 * p.y() + 8.0 * p.z() + 2.1) * WAYS[1] +
                     std::sin(8.0 * p.x() - 10.0 * p.y() + 6.0 * p.z() + 4.0) * WAYS[2]);
}

}  // namespace

FleshField::FleshField(const BodyShape& shape) {
  lower_.setConstant(1e9);
  upper_.setConstant(-1e9);
  for (const Part& part : shape.parts) {
    Flattened f;
    f.part = part;
    f.stretch = Eigen::Matrix3d::Identity() +
                (1 / part.flat - 1) * part.flat_axis * part.flat_axis.transpose();
    f.a = f.stretch * part.a;
    f.ab = f.stretch * (part.b - part.a);
    f.ab_sq = std::max(f.ab.squaredNorm(), 1e-12);
    const double radius = (std::max(part.radius_a, part.radius_b) + std::max(part.bulge, 0.0)) *
                          std::max(1.0, part.flat);
    f.center = 0.5 * (part.a + part.b);
    f.reach = 0.5 * (part.b - part.a).norm() + radius;
    const double margin = radius + part.blend + 3 * WARP;
    lower_ = lower_.cwiseMin(part.a.cwiseMin(part.b) - Vec3::Constant(margin));
    upper_ = upper_.cwiseMax(part.a.cwiseMax(part.b) + Vec3::Constant(margin));
    parts_.push_back(f);
  }
}

double FleshField::partDistance(int part, const Vec3& p) const {
  return nearest(part, warped(p)).distance;
}

FleshField::Nearest FleshField::nearest(int part, const Vec3& p) const {
  const Flattened& f = parts_[part];
  const Vec3 ap = f.stretch * p - f.a;
  const double t = std::clamp(ap.dot(f.ab) / f.ab_sq, 0.0, 1.0);
  const Vec3 off = ap - t * f.ab;
  const double length = off.norm();
  const double radius =
      f.part.radius_a + t * (f.part.radius_b - f.part.radius_a) + 4 * t * (1 - t) * f.part.bulge;
  if (f.part.flat == 1) return {length - radius, radius};
  // The stretched distance grows by |stretch * n| per unit of way: divided out to first order.
  const double slope = length > 1e-9 ? (f.stretch * off).norm() / length : 1.0;
  return {(length - radius) / slope, radius * std::min(f.part.flat, 1.0)};
}

double FleshField::value(const Vec3& place) const {
  const Vec3 p = warped(place);
  double d = 1e3;
  for (int i = 0; i < numParts(); ++i) {
    const Flattened& f = parts_[i];
    const double bound = d + f.part.blend + f.reach;
    if (bound <= 0 || (p - f.center).squaredNorm() > bound * bound) continue;
    d = smoothMin(d, nearest(i, p).distance, f.part.blend);
  }
  return d;
}

Vec3 FleshField::gradient(const Vec3& p) const {
  // Differences along the corners of a tetrahedron: four values instead of six.
  constexpr double STEP = 5e-4;
  static const Vec3 CORNERS[4] = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
  Vec3 g = Vec3::Zero();
  for (const Vec3& corner : CORNERS) g += corner * value(p + STEP * corner);
  return g / (4 * STEP);
}

Vec3 FleshField::project(Vec3 p) const {
  for (int i = 0; i < 8; ++i) {
    const double d = value(p);
    if (std::abs(d) < 1e-6) break;
    const Vec3 g = gradient(p);
    const double step = d / std::max(g.squaredNorm(), 0.1);
    p -= std::clamp(step, -0.02, 0.02) * g;
  }
  return p;
}

double FleshField::edgeLength(const Vec3& place, double edge) const {
  const Vec3 p = warped(place);
  double sum = 0, weights = 0;
  for (int i = 0; i < numParts(); ++i) {
    const Nearest near = nearest(i, p);
    const double far = std::max(near.distance, 0.0) / DETAIL_REACH;
    if (far >= 1) continue;
    const double length = std::min(edge * parts_[i].part.detail, EDGE_PER_RADIUS * near.radius);
    const double w = (1 - far * far) * (1 - far * far) / (length * length);
    sum += w * length;
    weights += w;
  }
  return weights > 0 ? sum / weights : edge;
}

}  // namespace posture::synthesis
