// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/synthesis/articulated_body.h>

#include <Eigen/Geometry>

#include <string>
#include <vector>

namespace posture::synthesis {

using Vec3 = Eigen::Vector3d;

/// A direction of the frame. Vectors at namespace scope would be zero for bodies that a program
/// makes before its main().
struct Axis {
  int number;
  operator Vec3() const { return Vec3::Unit(number); }
};
constexpr Axis X{0}, Y{1}, Z{2};

/// Degrees about the bone's own axes.
struct JointAngles {
  double flex = 0;
  double side = 0;
  double twist = 0;
};

/// A bone turns about `joint`. Axes in the rest pose: twist along the bone, flex as given,
/// side = twist x flex. A positive flex of a hanging limb swings it forward, a positive side
/// swings it away from the body.
struct Bone {
  std::string name;
  int parent = -1;
  Vec3 joint = Vec3::Zero();
  Vec3 end = Vec3::Zero();
  Vec3 flex_axis = Vec3::UnitX();
  Vec3 plane_normal = Vec3::Zero();  ///< unit; the surface beyond the plane at the joint follows
  double blend = 0.03;               ///< half the way over which it begins to follow
  double gate =
      0;  ///< > 0: root of a limb; half the distance over which the limb parts from the rest
  JointAngles lower, upper;  ///< limits of random poses
  bool reflected = false;    ///< the twin of a paired bone: turns the other way about its length
};

/// A cone with round ends between two points, flattened along an axis: a piece of flesh on a bone.
struct Part {
  int bone = 0;
  Vec3 a, b;
  double radius_a = 0, radius_b = 0;
  Vec3 flat_axis = Vec3::UnitX();
  double flat = 1;      ///< factor on the extent along flat_axis
  double blend = 0.03;  ///< distance over which it melts into its neighbours
  double detail = 1;    ///< edge length here relative to the whole
  double bulge = 0;     ///< added to the radius half-way
};

struct BodyShape {
  std::vector<Bone> bones;  ///< parents before children
  std::vector<Part> parts;
};

/// One named joint of a pose made by hand. Names end in _r or _l for paired bones; a name without
/// that ending moves both alike where the bone is paired.
struct PosedJoint {
  const char* bone;
  JointAngles angles;
};
using PoseTable = std::vector<PosedJoint>;

BodyShape quadrupedShape();
BodyShape humanShape();
const std::vector<PoseTable>& quadrupedPoses();
const std::vector<PoseTable>& humanPoses();

/// Collects bones and parts; whatever is added to a paired bone gets a twin reflected in x = 0.
class ShapeBuilder {
 public:
  /// `bone.parent` is ignored in favour of the parent's name.
  void addBone(Bone bone, const std::string& parent, bool paired);
  void addPart(const std::string& bone, Part part);
  BodyShape take() { return std::move(shape_); }

 private:
  int find(const std::string& name) const;
  BodyShape shape_;
};

}  // namespace posture::synthesis
