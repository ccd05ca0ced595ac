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

/// Vertices on their way onto a posed surface.
class SlidingPart {
 public:
  /// All but the motion and the weight are referred to.
  SlidingPart(const PosedSurface& surface,
              const Points& rest,
              const std::vector<WeighedVertex>& of,
              const Eigen::Isometry3d& start,
              double along)
      : surface_(surface),
        rest_(rest),
        of_(of),
        along_(along),
        motion_(start),
        normal_(of.size()),
        whole_(of.size()),
        off_(of.size()) {
    for (const auto& [v, weight] : of) {
      centre_ += weight * rest.row(v).transpose();
      total_ += weight;
    }
    centre_ /= total_;
    near_.reserve(of.size());
    for (const auto& [v, weight] : of) {
      spread_ += weight * (rest.row(v).transpose() - centre_).squaredNorm();
      near_.push_back(v);
    }
  }

  const Eigen::Isometry3d& motion() const { return motion_; }

  /// Finds the places and planes where the vertices are now. \return  the misfit.
  double look() {
    forEach(static_cast<int>(of_.size()), [&](int i) {
      const int v = of_[i].vertex;
      const Vector3d p = motion_ * Vector3d(rest_.row(v));
      const PosedSurface::Place place = surface_.nearest(p, near_[i]);
      const double across = place.normal.dot(p - place.at);
      // Along the surface to its own place, across it to the surface itself.
      const Vector3d away = p - Vector3d(surface_.places().row(v));
      normal_[i] = place.normal;
      whole_[i] = away + (across - place.normal.dot(away)) * place.normal;
      off_[i] = squaredDistance(across * place.normal, whole_[i], along_);
    });
    double misfit = 0;
    for (std::size_t i = 0; i < of_.size(); ++i) misfit += of_[i].weight * off_[i];
    return misfit;
  }

  /// Towards these. \return  false: that was hardly any way.
  bool step(bool robust) {
    const Vector3d about = motion_ * centre_;
    Vector6 step = bestStep(about, robust);
    double angle = step.head<3>().norm();
    if (angle > LARGEST_STEP) {
      step *= LARGEST_STEP / angle;
      angle = LARGEST_STEP;
    }
    Eigen::Isometry3d by =
        Eigen::Translation3d(about + step.tail<3>()) * Eigen::Isometry3d::Identity();
    if (angle > 0) by.rotate(Eigen::AngleAxisd(angle, step.head<3>() / angle));
    motion_ = by * Eigen::Translation3d(-about) * motion_;
    return !(angle < SMALLEST_STEP &&
             step.tail<3>().norm() < SMALLEST_STEP * std::sqrt(spread_ / total_));
  }

 private:
  /// A turn about a place, and a shift.
  Vector6 bestStep(const Vector3d& about, bool robust) const {
    const std::vector<double> factor =
        robust ? robustFactors(off_) : std::vector<double>(of_.size(), 1.0);
    Matrix6 of_steps = Matrix6::Zero();
    Vector6 pull = Vector6::Zero();
    for (std::size_t i = 0; i < of_.size(); ++i) {
      const Vector3d arm = motion_ * Vector3d(rest_.row(of_[i].vertex)) - about;
      Eigen::Matrix<double, 3, 6> moved;  // by a turn and a shift
      moved << 0, arm[2], -arm[1], 1, 0, 0, -arm[2], 0, arm[0], 0, 1, 0, arm[1], -arm[0], 0, 0, 0,
          1;
      const Matrix3d metric =
          along_ * Matrix3d::Identity() + (1 - along_) * normal_[i] * normal_[i].transpose();
      const Eigen::Matrix<double, 6, 3> weighed =
          factor[i] * of_[i].weight * moved.transpose() * metric;
      of_steps += weighed * moved;
      pull -= weighed * whole_[i];
    }
    constexpr double STILL = 1e-9;  // against what moves it nowhere, as places all in a row
    of_steps.diagonal().head<3>().array() += STILL * spread_;
    of_steps.diagonal().tail<3>().array() += STILL * total_;
    return of_steps.ldlt().solve(pull);
  }

  const PosedSurface& surface_;
  const Points& rest_;
  const std::vector<WeighedVertex>& of_;
  double along_;
  Eigen::Isometry3d motion_;
  Vector3d centre_ = Vector3d::Zero();
  double total_ = 0, spread_ = 0;         ///< weight, and second moment about the centre
  std::vector<int> near_;                 ///< of each vertex the nearest one of the surface
  std::vector<Vector3d> normal_, whole_;  ///< of the surface there; the way from its own place
  std::vector<double> off_;               ///< squared distances
};

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
                     const SlidingOptions& options) {
  SlidingPart part(surface, rest, of, start, options.along);
  int rounds = options.rounds;
  for (int round = 0;; ++round) {
    const double misfit = part.look();
    if (round == rounds) return {part.motion(), misfit};
    if (!part.step(options.robust)) rounds = round + 1;  // only the misfit is left to find
  }
}

}  // namespace posture
