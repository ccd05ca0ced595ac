// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "poses.h"

#include <posture/core/error.h>
#include <posture/core/rng.h>

#include "skinning.h"
#include <algorithm>
#include <cstdint>

namespace posture::synthesis {
namespace {

constexpr int MAX_DRAWS = 60;
constexpr double SHRINK = 0.96;           // of the range, with every draw that collides
constexpr double REST_CLEARANCE = 0.012;  // parts nearer than this at rest belong together
constexpr double POSED_CLEARANCE = 0.006;

bool matches(const std::string& bone, const std::string& name) {
  return bone == name || bone == name + "_r" || bone == name + "_l";
}

std::vector<JointAngles> fromTable(const BodyShape& shape, const PoseTable& table) {
  std::vector<JointAngles> angles(shape.bones.size());
  for (const PosedJoint& joint : table) {
    bool found = false;
    for (std::size_t b = 0; b < shape.bones.size(); ++b) {
      if (!matches(shape.bones[b].name, joint.bone)) continue;
      angles[b] = joint.angles;
      found = true;
    }
    require(found, std::string("pose of an unknown bone ") + joint.bone);
  }
  return angles;
}

/// Distance between two segments (Ericson, Real-Time Collision Detection, 5.1.9).
double segmentDistance(const Vec3& p, const Vec3& q, const Vec3& r, const Vec3& s) {
  const Vec3 d1 = q - p, d2 = s - r, between = p - r;
  const double a = d1.squaredNorm() + 1e-12, e = d2.squaredNorm() + 1e-12;
  const double b = d1.dot(d2), c = d1.dot(between), f = d2.dot(between);
  const double denominator = a * e - b * b;
  double u = denominator > 1e-12 ? std::clamp((b * f - c * e) / denominator, 0.0, 1.0) : 0.0;
  double v = std::clamp((b * u + f) / e, 0.0, 1.0);
  u = std::clamp((b * v - c) / a, 0.0, 1.0);
  return (p + u * d1 - r - v * d2).norm();
}

double clearance(const Part& m, const Part& n) {
  const double thick_m = std::max(m.radius_a, m.radius_b) * std::min(m.flat, 1.0);
  const double thick_n = std::max(n.radius_a, n.radius_b) * std::min(n.flat, 1.0);
  return segmentDistance(m.a, m.b, n.a, n.b) - thick_m - thick_n;
}

bool collides(const BodyShape& shape, const std::vector<JointAngles>& angles) {
  const std::vector<Eigen::Isometry3d> motions = boneMotions(shape, angles);
  const auto posed = [&](Part part) {
    part.a = motions[part.bone] * part.a;
    part.b = motions[part.bone] * part.b;
    return part;
  };
  for (std::size_t i = 0; i < shape.parts.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const Part &m = shape.parts[i], &n = shape.parts[j];
      if (m.bone == n.bone || clearance(m, n) < REST_CLEARANCE) continue;
      if (clearance(posed(m), posed(n)) < POSED_CLEARANCE) return true;
    }
  return false;
}

std::vector<JointAngles> draw(const BodyShape& shape, int pose) {
  Rng rng(0x9053ull + static_cast<std::uint64_t>(static_cast<std::int64_t>(pose)));
  const auto between = [&](double low, double high) { return low + (high - low) * rng.uniform(); };
  std::vector<JointAngles> angles(shape.bones.size());
  double range = 1;
  for (int i = 0; i < MAX_DRAWS; ++i, range *= SHRINK) {
    for (std::size_t b = 0; b < shape.bones.size(); ++b) {
      const Bone& bone = shape.bones[b];
      angles[b].flex = range * between(bone.lower.flex, bone.upper.flex);
      angles[b].side = range * between(bone.lower.side, bone.upper.side);
      angles[b].twist = range * between(bone.lower.twist, bone.upper.twist);
    }
    if (!collides(shape, angles)) break;
  }
  return angles;
}

}  // namespace

std::vector<JointAngles> jointAngles(const BodyShape& shape,
                                     const std::vector<PoseTable>& table,
                                     int pose) {
  if (pose == 0) return std::vector<JointAngles>(shape.bones.size());
  if (pose > 0 && pose <= static_cast<int>(table.size())) return fromTable(shape, table[pose - 1]);
  return draw(shape, pose);
}

}  // namespace posture::synthesis
