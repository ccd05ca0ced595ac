// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/error.h>

#include "skeleton.h"

namespace posture::synthesis {
namespace {

Vec3 reflect(const Vec3& v) { return {-v.x(), v.y(), v.z()}; }

/// A rotation about `axis` becomes, reflected, the one about this axis by the same angle.
Vec3 reflectAxis(const Vec3& axis) { return {axis.x(), -axis.y(), -axis.z()}; }

}  // namespace

int ShapeBuilder::find(const std::string& name) const {
  for (std::size_t i = 0; i < shape_.bones.size(); ++i)
    if (shape_.bones[i].name == name) return static_cast<int>(i);
  return -1;
}

void ShapeBuilder::addBone(Bone bone, const std::string& parent, bool paired) {
  if (bone.plane_normal.isZero()) bone.plane_normal = bone.end - bone.joint;
  bone.plane_normal.normalize();
  const std::string name = bone.name;
  const auto add = [&](const std::string& side) {
    bone.name = name + side;
    bone.parent = find(parent + side);
    if (bone.parent < 0) bone.parent = find(parent);
    require(bone.parent >= 0 || shape_.bones.empty(), "bone " + name + " has no parent " + parent);
    shape_.bones.push_back(bone);
  };
  if (!paired) return add("");
  add("_r");
  bone.joint = reflect(bone.joint);
  bone.end = reflect(bone.end);
  bone.plane_normal = reflect(bone.plane_normal);
  bone.flex_axis = reflectAxis(bone.flex_axis);
  bone.reflected = true;
  add("_l");
}

void ShapeBuilder::addPart(const std::string& bone, Part part) {
  const int single = find(bone);
  part.bone = single >= 0 ? single : find(bone + "_r");
  require(part.bone >= 0, "no bone " + bone);
  part.flat_axis.normalize();
  shape_.parts.push_back(part);
  const bool on_midline = part.a.x() == 0 && part.b.x() == 0;
  if (single >= 0 && on_midline) return;
  if (single < 0) part.bone = find(bone + "_l");
  part.a = reflect(part.a);
  part.b = reflect(part.b);
  part.flat_axis = reflect(part.flat_axis);
  shape_.parts.push_back(part);
}

}  // namespace posture::synthesis
