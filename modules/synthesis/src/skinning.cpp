// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "skinning.h"

#include <posture/core/parallel.h>

#include <algorithm>
#include <cmath>

namespace posture::synthesis {
namespace {

/// 0 below -1, 1 above 1, two continuous derivatives.
double smoothStep(double x) {
  const double t = std::clamp(0.5 * (x + 1), 0.0, 1.0);
  return t * t * t * (10 + t * (6 * t - 15));
}

class Weigher {
 public:
  Weigher(const BodyShape& shape, const FleshField& field) : shape_(shape), field_(field) {
    const std::size_t n = shape.bones.size();
    in_subtree_.assign(n, std::vector<bool>(n, false));
    for (std::size_t b = 0; b < n; ++b)
      for (int up = static_cast<int>(b); up >= 0; up = shape.bones[up].parent)
        in_subtree_[up][b] = true;
  }

  Vector weights(const Vec3& p) const {
    const std::vector<double> share = shares(p);
    const int n = static_cast<int>(share.size());
    Vector w(n);
    for (int b = 0; b < n; ++b) w[b] = share[b];
    for (int b = 1; b < n; ++b) w[shape_.bones[b].parent] -= share[b];
    w = w.cwiseMax(0);
    return w / w.sum();
  }

 private:
  /// Share of each bone together with all that hangs on it.
  std::vector<double> shares(const Vec3& p) const {
    const int n = static_cast<int>(shape_.bones.size());
    std::vector<double> distance(field_.numParts());
    for (int i = 0; i < field_.numParts(); ++i) distance[i] = field_.partDistance(i, p);
    std::vector<double> share(n, 0);
    for (int b = 0; b < n; ++b)
      if (shape_.bones[b].gate > 0) share[b] = gate(b, distance) * pastPlane(b, p);
    share[0] = 1;
    for (int b = 1; b < n; ++b) {
      const Bone& bone = shape_.bones[b];
      if (bone.gate > 0) continue;
      const double own = 1 - std::min(1.0, limbsBeside(b, share));
      share[b] = share[bone.parent] * pastPlane(b, p) * own;
    }
    for (int b = n - 1; b > 0; --b) {
      double& parent = share[shape_.bones[b].parent];
      parent = std::max(parent, share[b]);
    }
    return share;
  }

  double pastPlane(int b, const Vec3& p) const {
    const Bone& bone = shape_.bones[b];
    return smoothStep(bone.plane_normal.dot(p - bone.joint) / bone.blend);
  }

  /// 1 on the limb that begins with bone b, 0 on the rest of the body.
  double gate(int b, const std::vector<double>& distance) const {
    double limb = 1, rest = 1;
    for (int i = 0; i < field_.numParts(); ++i) {
      double& side = in_subtree_[b][shape_.parts[i].bone] ? limb : rest;
      side = std::min(side, distance[i]);
    }
    return smoothStep((rest - limb) / shape_.bones[b].gate);
  }

  /// What limbs take here that are neither part of bone b's subtree nor carry bone b.
  double limbsBeside(int b, const std::vector<double>& share) const {
    double sum = 0;
    for (std::size_t g = 0; g < shape_.bones.size(); ++g)
      if (shape_.bones[g].gate > 0 && !in_subtree_[b][g] && !in_subtree_[g][b]) sum += share[g];
    return sum;
  }

  const BodyShape& shape_;
  const FleshField& field_;
  std::vector<std::vector<bool>> in_subtree_;  ///< [ancestor or self][bone]
};

}  // namespace

Matrix skinWeights(const BodyShape& shape, const FleshField& field, const Points& rest) {
  const Weigher weigher(shape, field);
  Matrix weights(rest.rows(), static_cast<Eigen::Index>(shape.bones.size()));
  forEach(static_cast<int>(rest.rows()),
          [&](int i) { weights.row(i) = weigher.weights(rest.row(i).transpose()).transpose(); });
  return weights;
}

std::vector<Eigen::Isometry3d> boneMotions(const BodyShape& shape,
                                           const std::vector<JointAngles>& angles) {
  constexpr double DEGREE = M_PI / 180;
  std::vector<Eigen::Isometry3d> motions;
  for (std::size_t b = 0; b < shape.bones.size(); ++b) {
    const Bone& bone = shape.bones[b];
    const Vec3 twist = (bone.reflected ? -1 : 1) * (bone.end - bone.joint).normalized();
    const Vec3 flex = (bone.flex_axis - bone.flex_axis.dot(twist) * twist).normalized();
    const Vec3 side = twist.cross(flex);
    Eigen::Isometry3d turn = Eigen::Isometry3d::Identity();
    turn.translate(bone.joint);
    turn.rotate(Eigen::AngleAxisd(angles[b].side * DEGREE, side));
    turn.rotate(Eigen::AngleAxisd(angles[b].flex * DEGREE, flex));
    turn.rotate(Eigen::AngleAxisd(angles[b].twist * DEGREE, twist));
    turn.translate(-bone.joint);
    motions.push_back(bone.parent < 0 ? turn : motions[bone.parent] * turn);
  }
  return motions;
}

Points skin(const Points& rest,
            const Matrix& weights,
            const std::vector<Eigen::Isometry3d>& motions) {
  const std::size_t num_bones = motions.size();
  std::vector<Eigen::Vector4d> real(num_bones), dual(num_bones);
  for (std::size_t b = 0; b < num_bones; ++b) {
    const Eigen::Quaterniond q(motions[b].linear());
    const Vec3 t = motions[b].translation();
    real[b] = q.coeffs();
    dual[b] = 0.5 * (Eigen::Quaterniond(0, t.x(), t.y(), t.z()) * q).coeffs();
  }
  Points posed(rest.rows(), 3);
  for (Eigen::Index i = 0; i < rest.rows(); ++i) {
    Eigen::Index most = 0;
    weights.row(i).maxCoeff(&most);
    Eigen::Vector4d r = Eigen::Vector4d::Zero(), d = Eigen::Vector4d::Zero();
    for (std::size_t b = 0; b < num_bones; ++b) {
      const double w = weights(i, static_cast<Eigen::Index>(b));
      if (w == 0) continue;
      const double sign = real[b].dot(real[most]) < 0 ? -1 : 1;  // q and -q turn alike
      r += sign * w * real[b];
      d += sign * w * dual[b];
    }
    const double length = r.norm();
    const Eigen::Quaterniond q(Eigen::Vector4d(r / length)), moved(Eigen::Vector4d(d / length));
    const Vec3 t = 2 * (moved * q.conjugate()).vec();
    posed.row(i) = q * Vec3(rest.row(i)) + t;
  }
  return posed;
}

}  // namespace posture::synthesis
