// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sliding_fit.h"

#include <posture/core/parallel.h>
#include <posture/mesh/nearest_on_faces.h>
#include <posture/mesh/normals.h>

#include <Eigen/Cholesky>

#include "joint.h"
#include "robust_factors.h"
#include <algorithm>
#include <cmath>

namespace posture {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double LARGEST_STEP = 0.3;    // radians: the planes are no good beyond
constexpr double SMALLEST_STEP = 1e-7;  // radians, and parts of the size

double squaredDistance(const Vector3d& across, const Vector3d& whole, double along) {
  return (1 - along) * across.squaredNorm() + along * whole.squaredNorm();
}

}  // namespace

PosedSurface::PosedSurface(const Points& places, const Faces& faces)
    : places_(places),
      normals_(vertexNormals({places, faces})),
      faces_(faces),
      faces_at_(faces, static_cast<int>(places.rows())) {}

PosedSurface::Place PosedSurface::nearest(const Vector3d& point, int& from) const {
  const auto squared = [&](int v) { return (Vector3d(places_.row(v)) - point).squaredNorm(); };
  double least = squared(from);
  for (bool nearer = true; nearer;) {
    nearer = false;
    const int here = from;
    for (const int* f = faces_at_.begin(here); f != faces_at_.end(here); ++f)
      for (int v : faces_.row(*f)) {
        if (!(squared(v) < least)) continue;
        least = squared(v);
        from = v;
        nearer = true;
      }
  }
  NearestPlace best(places_.row(from), point);
  lookAround(places_, faces_, faces_at_, from, point, best);
  if (best.face < 0) return {best.place, normals_.row(from)};
  const auto corners = faces_.row(best.face);
  const Vector3d& w = best.barycentric;
  return {best.place,
          (w[0] * normals_.row(corners[0]) + w[1] * normals_.row(corners[1]) +
           w[2] * normals_.row(corners[2]))
              .normalized()};
}

SlidingFit slideOnto(const PosedSurface& surface,
                     const Points& rest,
                     const std::vector<WeighedVertex>& of,
                     const Eigen::Isometry3d& start,
                     double along,
                     int rounds,
                     bool robust) {
  Vector3d centre = Vector3d::Zero();
  double total = 0, spread = 0;
  for (const auto& [v, weight] : of) {
    centre += weight * rest.row(v).transpose();
    total += weight;
  }
  centre /= total;
  for (const auto& [v, weight] : of)
    spread += weight * (rest.row(v).transpose() - centre).squaredNorm();

  SlidingFit fit{start, 0};
  std::vector<int> near;
  for (const auto& [v, weight] : of) near.push_back(v);
  std::vector<Vector3d> normal(of.size()), whole(of.size());
  std::vector<double> off(of.size()), factor(of.size(), 1.0);
  for (int round = 0;; ++round) {
    forEach(static_cast<int>(of.size()), [&](int i) {
      const int v = of[i].vertex;
      const Vector3d p = fit.motion * Vector3d(rest.row(v));
      const PosedSurface::Place place = surface.nearest(p, near[i]);
      const double across = place.normal.dot(p - place.at);
      // Along the surface to its own place, across it to the surface itself.
      const Vector3d away = p - Vector3d(surface.places().row(v));
      normal[i] = place.normal;
      whole[i] = away + (across - place.normal.dot(away)) * place.normal;
      off[i] = squaredDistance(across * place.normal, whole[i], along);
    });
    fit.misfit = 0;
    for (std::size_t i = 0; i < of.size(); ++i) fit.misfit += of[i].weight * off[i];
    if (round == rounds) return fit;
    if (robust) factor = robustFactors(off);
    Matrix6 of_steps = Matrix6::Zero();
    Vector6 pull = Vector6::Zero();
    const Vector3d about = fit.motion * centre;
    for (std::size_t i = 0; i < of.size(); ++i) {
      const Vector3d arm = fit.motion * Vector3d(rest.row(of[i].vertex)) - about;
      Eigen::Matrix<double, 3, 6> moved;  // by a turn and a shift
      moved << 0, arm[2], -arm[1], 1, 0, 0, -arm[2], 0, arm[0], 0, 1, 0, arm[1], -arm[0], 0, 0, 0,
          1;
      const Matrix3d metric =
          along * Matrix3d::Identity() + (1 - along) * normal[i] * normal[i].transpose();
      const Eigen::Matrix<double, 6, 3> weighed =
          factor[i] * of[i].weight * moved.transpose() * metric;
      of_steps += weighed * moved;
      pull -= weighed * whole[i];
    }
    constexpr double STILL = 1e-9;  // against what moves it nowhere, as places all in a row
    of_steps.diagonal().head<3>().array() += STILL * spread;
    of_steps.diagonal().tail<3>().array() += STILL * total;
    Vector6 step = of_steps.ldlt().solve(pull);
    double angle = step.head<3>().norm();
    if (angle > LARGEST_STEP) {
      step *= LARGEST_STEP / angle;
      angle = LARGEST_STEP;
    }
    Eigen::Isometry3d by =
        Eigen::Translation3d(about + step.tail<3>()) * Eigen::Isometry3d::Identity();
    if (angle > 0) by.rotate(Eigen::AngleAxisd(angle, step.head<3>() / angle));
    fit.motion = by * Eigen::Translation3d(-about) * fit.motion;
    if (angle < SMALLEST_STEP && step.tail<3>().norm() < SMALLEST_STEP * std::sqrt(spread / total))
      rounds = round + 1;  // only the misfit is left to find
  }
}

}  // namespace posture
