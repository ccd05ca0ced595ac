// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "skeleton.h"

namespace posture::synthesis {
namespace {

// Rows of numbers.
// clang-format off
void addBones(ShapeBuilder& body) {
  const auto bone = [&](const char* name, const char* parent, const Vec3& joint, const Vec3& end,
                        const Vec3& normal, double blend, double gate, JointAngles lower,
                        JointAngles upper) {
    body.addBone({name, -1, joint, end, X, normal, blend, gate, lower, upper}, parent, false);
  };
  const auto pair = [&](const char* name, const char* parent, const Vec3& joint, const Vec3& end,
                        const Vec3& normal, double blend, double gate, JointAngles lower,
                        JointAngles upper) {
    body.addBone({name, -1, joint, end, X, normal, blend, gate, lower, upper}, parent, true);
  };
  const Vec3 along = Vec3::Zero();  // the plane across the bone itself
  bone("pelvis", "", {0, -.18, .46}, {0, -.32, .46}, along, .05, 0, {}, {});
  bone("loin", "pelvis", {0, -.17, .47}, {0, -.02, .47}, along, .065, 0,
       {-16, -12, -8}, {10, 12, 8});
  bone("chest", "loin", {0, -.02, .47}, {0, .16, .47}, along, .065, 0, {-12, -12, -8}, {10, 12, 8});
  bone("neck", "chest", {0, .18, .47}, {0, .27, .57}, {0, .75, .66}, .06, .08,
       {-25, -20, -15}, {20, 20, 15});
  bone("nape", "neck", {0, .26, .565}, {0, .335, .65}, along, .045, 0,
       {-20, -20, -15}, {18, 20, 15});
  bone("head", "nape", {0, .335, .65}, {0, .49, .63}, {0, .9, .25}, .04, 0,
       {-25, -25, -20}, {20, 25, 20});
  bone("tail1", "pelvis", {0, -.335, .495}, {0, -.42, .47}, along, .03, .025,
       {-25, -30, 0}, {35, 30, 0});
  bone("tail2", "tail1", {0, -.42, .47}, {0, -.50, .435}, along, .035, 0,
       {-25, -25, 0}, {30, 25, 0});
  bone("tail3", "tail2", {0, -.50, .435}, {0, -.57, .39}, along, .035, 0,
       {-25, -25, 0}, {30, 25, 0});
  bone("tail4", "tail3", {0, -.57, .39}, {0, -.63, .335}, along, .03, 0,
       {-25, -25, 0}, {30, 25, 0});
  pair("upper_arm", "chest", {.065, .155, .42}, {.07, .095, .29}, {.35, 0, -1}, .06, .06,
       {-30, -4, -5}, {35, 12, 5});
  pair("forearm", "upper_arm", {.07, .095, .29}, {.07, .125, .135}, {0, .1, -1}, .04, 0,
       {-15, 0, 0}, {60, 0, 0});
  pair("forepaw", "forearm", {.07, .125, .125}, {.07, .165, .02}, {0, .1, -1}, .028, 0,
       {-70, 0, 0}, {15, 0, 0});
  pair("thigh", "pelvis", {.06, -.25, .43}, {.075, -.185, .28}, {.4, .35, -1}, .065, .06,
       {-30, -3, -5}, {40, 14, 5});
  pair("shank", "thigh", {.075, -.185, .275}, {.072, -.305, .16}, {0, -.62, -.78}, .045, 0,
       {-45, 0, 0}, {20, 0, 0});
  pair("hock", "shank", {.072, -.305, .155}, {.07, -.28, .045}, {0, -.25, -1}, .03, 0,
       {-15, 0, 0}, {45, 0, 0});
  pair("hindpaw", "hock", {.07, -.28, .045}, {.07, -.225, .02}, {0, .7, -.7}, .022, 0,
       {-15, 0, 0}, {35, 0, 0});
}

void addTrunk(ShapeBuilder& body) {
  const auto cone =
      [&](const char* bone, const Vec3& a, double ra, const Vec3& b, double rb, double flat,
          double blend) {
        body.addPart(bone, {0, a, b, ra, rb, X, flat, blend, 1});
      };
  cone("chest", {0, .15, .435}, .103, {0, .02, .436}, .106, .76, .02);  // ribs
  cone("chest", {0, .16, .505}, .05, {0, -.05, .48}, .052, .9, .06);  // withers
  cone("chest", {0, .195, .425}, .062, {0, .16, .385}, .06, .95, .03);  // breast
  cone("loin", {0, .02, .436}, .106, {0, -.15, .462}, .081, .80, .01);  // belly, drawn in
  cone("pelvis", {0, -.15, .462}, .081, {0, -.27, .463}, .076, .86, .01);
  cone("pelvis", {.035, -.255, .465}, .056, {.04, -.285, .445}, .055, 1, .04);  // croup
  cone("tail1", {0, -.32, .495}, .033, {0, -.42, .47}, .0265, 1, .025);
  cone("tail2", {0, -.42, .47}, .0265, {0, -.50, .435}, .0245, 1, .005);
  cone("tail3", {0, -.50, .435}, .0245, {0, -.57, .39}, .020, 1, .005);
  cone("tail4", {0, -.57, .39}, .020, {0, -.625, .34}, .013, 1, .005);
}

void addHead(ShapeBuilder& body) {
  const auto part = [&](const char* bone, const Vec3& a, double ra, const Vec3& b, double rb,
                        const Vec3& axis, double flat, double blend, double detail) {
    body.addPart(bone, {0, a, b, ra, rb, axis, flat, blend, detail});
  };
  part("neck", {0, .15, .455}, .088, {0, .26, .565}, .066, X, .84, .03, 1);
  part("nape", {0, .26, .565}, .066, {0, .33, .645}, .057, X, .88, .01, .9);
  part("head", {0, .335, .673}, .057, {0, .362, .67}, .055, X, .98, .02, .8);  // skull
  part("head", {.026, .345, .655}, .04, {.022, .375, .65}, .036, X, 1, .03, .8);  // cheeks
  part("head", {0, .385, .662}, .042, {0, .475, .642}, .026, X, .9, .03, .7);  // muzzle
  part("head", {0, .484, .650}, .014, {0, .494, .648}, .013, X, 1.15, .012, .6);  // nose
  part("head", {0, .37, .638}, .032, {0, .455, .622}, .018, X, 1.1, .03, .7);  // jaw
  part("head", {.026, .392, .695}, .013, {.022, .408, .688}, .010, X, 1, .025, .7);  // brow
  // ear
  part("head", {.034, .33, .72}, .032, {.053, .318, .782}, .016, {.35, 1, .1}, .55, .02, .55);
}

void addLegs(ShapeBuilder& body) {
  const auto cone = [&](const char* bone, const Vec3& a, double ra, const Vec3& b, double rb,
                        double flat, double blend, double detail, double bulge) {
    body.addPart(bone, {0, a, b, ra, rb, X, flat, blend, detail, bulge});
  };
  cone("chest", {.045, .12, .50}, .045, {.055, .155, .43}, .056, .8, .05, 1, 0);  // shoulder blade
  cone("upper_arm", {.062, .145, .42}, .058, {.07, .10, .295}, .036, .8, .035, 1, .002);
  cone("forearm", {.07, .10, .295}, .036, {.07, .127, .125}, .022, .9, .006, .8, .001);
  cone("forepaw", {.07, .127, .125}, .022, {.07, .135, .04}, .0215, 1, .006, .7, 0);
  body.addPart("forepaw", {0, {.07, .137, .025}, {.07, .17, .02}, .029, .026, Z, .72, .015, .65});
  cone("thigh", {.06, -.25, .43}, .075, {.075, -.19, .275}, .041, .7, .04, 1, .004);
  cone("shank", {.075, -.19, .275}, .041, {.072, -.304, .162}, .021, .8, .008, .8, .001);
  cone("hock", {.072, -.307, .16}, .021, {.07, -.283, .04}, .0185, 1, .008, .7, -.001);
  body.addPart("hindpaw", {0, {.07, -.28, .024}, {.07, -.238, .019}, .027, .025, Z, .72, .015,
       .65});
}

// clang-format on

}  // namespace

BodyShape quadrupedShape() {
  ShapeBuilder body;
  addBones(body);
  addTrunk(body);
  addHead(body);
  addLegs(body);
  return body.take();
}

}  // namespace posture::synthesis
