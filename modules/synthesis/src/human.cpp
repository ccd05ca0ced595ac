// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "skeleton.h"

namespace posture::synthesis {
namespace {

// Rows of numbers.
// clang-format off
void addBones(ShapeBuilder& body) {
  const auto bone = [&](const char* name, const char* parent, const Vec3& joint, const Vec3& end,
                        double blend, double gate, JointAngles lower, JointAngles upper) {
    body.addBone(
        {name, -1, joint, end, -Vec3(X), Vec3::Zero(), blend, gate, lower, upper}, parent, false);
  };
  const auto pair = [&](const char* name, const char* parent, const Vec3& joint, const Vec3& end,
                        const Vec3& flex, const Vec3& normal, double blend, double gate,
                        JointAngles lower, JointAngles upper) {
    body.addBone({name, -1, joint, end, flex, normal, blend, gate, lower, upper}, parent, true);
  };
  const Vec3 along = Vec3::Zero();
  bone("pelvis", "", {0, 0, .53}, {0, 0, .58}, .05, 0, {}, {});
  bone("waist", "pelvis", {0, 0, .585}, {0, 0, .66}, .05, 0, {-10, -10, -15}, {25, 10, 15});
  bone("chest", "waist", {0, 0, .665}, {0, 0, .80}, .06, 0, {-8, -10, -15}, {20, 10, 15});
  bone("neck", "chest", {0, -.005, .825}, {0, .002, .875}, .03, .03, {-15, -12, -25}, {15, 12, 25});
  bone("head", "neck", {0, .002, .875}, {0, .002, .98}, .025, 0, {-15, -12, -25}, {15, 12, 25});
  const Vec3 arm_flex(.707, 0, .707);  // the arm points outwards and down in the rest pose
  pair("clavicle", "chest", {.02, 0, .815}, {.11, -.005, .808}, Z, {1, 0, .35}, .05, .03,
       {0, -5, 0}, {0, 20, 0});
  pair("upper_arm", "clavicle", {.112, -.005, .803}, {.234, -.01, .682}, arm_flex, {1, 0, -.55},
       .045, 0, {-25, -35, -20}, {70, 60, 30});
  pair("forearm", "upper_arm", {.234, -.01, .682}, {.335, .002, .583}, arm_flex, along, .040, 0,
       {0, 0, -30}, {95, 0, 30});
  pair("hand", "forearm", {.335, .002, .583}, {.40, .008, .518}, arm_flex, along, .018, 0,
       {-15, -35, 0}, {15, 35, 0});
  pair("thigh", "pelvis", {.05, 0, .515}, {.072, .008, .285}, X, {.6, .1, -1}, .065, .045,
       {-20, -4, -8}, {70, 22, 10});
  pair("shin", "thigh", {.072, .008, .283}, {.086, -.012, .05}, X, along, .055, 0,
       {-85, 0, 0}, {0, 0, 0});
  pair("foot", "shin", {.086, -.012, .045}, {.098, .08, .015}, X, {0, .35, -1}, .02, 0,
       {-25, -8, 0}, {20, 8, 0});
}

void addTorso(ShapeBuilder& body) {
  const auto part = [&](const char* bone, const Vec3& a, double ra, const Vec3& b, double rb,
                        const Vec3& axis, double flat, double blend) {
    body.addPart(bone, {0, a, b, ra, rb, axis, flat, blend, 1});
  };
  part("pelvis", {0, -.002, .55}, .079, {0, -.002, .53}, .078, Y, .70, .02);
  part("pelvis", {.04, -.026, .518}, .044, {.042, -.024, .50}, .043, X, 1, .03);  // seat
  part("waist", {0, .004, .63}, .069, {0, .002, .565}, .077, Y, .70, .02);
  part("chest", {0, 0, .735}, .083, {0, .004, .64}, .070, Y, .70, .02);  // ribs
  part("chest", {.043, .026, .748}, .042, {.036, .026, .728}, .042, Y, .75, .03);  // breast
  part("chest", {.05, -.026, .76}, .042, {.04, -.024, .72}, .040, Y, .75, .03);  // shoulder blade
  part("clavicle", {.025, -.006, .80}, .038, {.10, -.006, .80}, .034, Y, .9, .02);
  part("clavicle", {.015, -.012, .845}, .022, {.085, -.01, .812}, .020, X, 1, .03);  // trapezius
}

void addHead(ShapeBuilder& body) {
  const auto part = [&](const char* bone, const Vec3& a, double ra, const Vec3& b, double rb,
                        const Vec3& axis, double flat, double blend, double detail) {
    body.addPart(bone, {0, a, b, ra, rb, axis, flat, blend, detail});
  };
  part("neck", {0, -.006, .80}, .035, {0, .002, .89}, .030, X, .98, .02, .9);
  part("head", {0, -.008, .944}, .054, {0, .006, .940}, .053, X, .85, .015, .8);  // skull
  part("head", {0, .018, .925}, .040, {0, .029, .893}, .027, X, .92, .015, .75);  // face, jaw
  part("head", {0, .040, .887}, .013, {0, .043, .884}, .012, X, 1.4, .02, .65);  // chin
  part("head", {0, .044, .905}, .011, {0, .044, .900}, .011, X, 1.5, .015, .65);  // mouth
  part("head", {0, .051, .936}, .006, {0, .0605, .917}, .0085, X, .9, .012, .5);  // nose
  part("head", {.012, .047, .946}, .009, {.028, .038, .943}, .009, Z, .7, .015, .6);  // brow
  part("head", {.044, -.004, .932}, .014, {.042, 0, .914}, .010, X, .55, .008, .5);  // ear
}

void addArms(ShapeBuilder& body) {
  const auto part = [&](const char* bone, const Vec3& a, double ra, const Vec3& b, double rb,
                        const Vec3& axis, double flat, double blend, double detail, double bulge) {
    body.addPart(bone, {0, a, b, ra, rb, axis, flat, blend, detail, bulge});
  };
  const Vec3 palm(.707, 0, .707);
  // deltoid
  part("upper_arm", {.112, -.005, .80}, .036, {.148, -.006, .765}, .031, X, 1, .02, 1, 0);
  part("upper_arm", {.14, -.006, .773}, .030, {.234, -.01, .682}, .0225, X, 1, .01, .9, .003);
  part("forearm", {.234, -.01, .682}, .0225, {.335, .002, .583}, .0165, palm, .95, .005, .8, .004);
  // palm
  part("hand", {.338, .003, .58}, .0165, {.372, .007, .546}, .027, palm, .5, .01, .6, .001);
  part("hand", {.372, .007, .546}, .027, {.414, .008, .504}, .017, palm, .5, .006, .55, .001);
  // thumb
  part("hand", {.346, .018, .572}, .012, {.370, .044, .546}, .0085, palm, .9, .012, .5, 0);
}

void addLegs(ShapeBuilder& body) {
  const auto cone = [&](const char* bone, const Vec3& a, double ra, const Vec3& b, double rb,
                        double blend, double detail, double bulge) {
    body.addPart(bone, {0, a, b, ra, rb, X, 1, blend, detail, bulge});
  };
  cone("thigh", {.05, .002, .515}, .050, {.072, .006, .285}, .0325, .02, 1, .0055);
  cone("shin", {.072, .006, .285}, .0325, {.086, -.012, .05}, .0185, .005, .85, .0015);
  cone("shin", {.077, -.006, .25}, .029, {.082, -.012, .13}, .023, .012, .85, .0055);  // calf
  const auto foot = [&](const Vec3& a, double ra, const Vec3& b, double rb, double flat,
                        double blend) {
    body.addPart("foot", {0, a, b, ra, rb, Z, flat, blend, .65});
  };
  foot({.086, -.020, .021}, .0205, {.086, -.013, .05}, .0185, 1, .01);  // heel
  foot({.086, -.010, .042}, .021, {.093, .045, .022}, .022, .85, .015);  // instep
  foot({.093, .040, .017}, .027, {.099, .085, .013}, .021, .6, .012);  // toes
}

// clang-format on

}  // namespace

BodyShape humanShape() {
  ShapeBuilder body;
  addBones(body);
  addTorso(body);
  addHead(body);
  addArms(body);
  addLegs(body);
  return body.take();
}

}  // namespace posture::synthesis
