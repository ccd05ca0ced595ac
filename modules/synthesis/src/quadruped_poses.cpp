// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "skeleton.h"

namespace posture::synthesis {

// Degrees {flex, side, twist}. Flex lifts what points forward, swings forward what hangs, lowers
// the tail; side turns to the body's right, or away from the body for paired bones.
const std::vector<PoseTable>& quadrupedPoses() {
  // clang-format off
  static const std::vector<PoseTable> POSES = {
      // 1: walking
      {{"upper_arm_r", {24, 0, 0}}, {"forearm_r", {4, 0, 0}}, {"forepaw_r", {-14, 0, 0}},
       {"upper_arm_l", {-24, 0, 0}}, {"forearm_l", {6, 0, 0}}, {"forepaw_l", {-8, 0, 0}},
       {"thigh_r", {-24, 0, 0}}, {"shank_r", {8, 0, 0}}, {"hock_r", {-6, 0, 0}},
       {"hindpaw_r", {16, 0, 0}}, {"thigh_l", {24, 0, 0}}, {"shank_l", {-18, 0, 0}},
       {"hock_l", {10, 0, 0}}, {"hindpaw_l", {-12, 0, 0}}, {"neck", {-8, 0, 0}},
       {"head", {6, 8, 0}}, {"tail1", {20, 8, 0}}, {"tail2", {8, 10, 0}}, {"tail3", {-10, 10, 0}}},
      // 2: sitting
      {{"pelvis", {36, 0, 0}}, {"loin", {4, 0, 0}}, {"chest", {4, 0, 0}},
       {"upper_arm", {-30, 7, 0}}, {"forearm", {-6, 0, 0}}, {"forepaw", {-4, 0, 0}},
       {"thigh", {14, 10, 0}}, {"shank", {-62, 0, 0}}, {"hock", {76, 0, 0}},
       {"hindpaw", {-64, 0, 0}}, {"neck", {-12, 0, 0}}, {"nape", {-8, 0, 0}},
       {"head", {-22, 12, 0}}, {"tail1", {-36, 10, 0}}, {"tail2", {-22, 14, 0}},
       {"tail3", {-14, 16, 0}}, {"tail4", {0, 16, 0}}},
      // 3: looking round over the left shoulder, tail raised
      {{"loin", {0, -8, 0}}, {"chest", {0, -12, 0}}, {"neck", {8, -34, 0}}, {"nape", {4, -28, 0}},
       {"head", {-6, -30, -8}}, {"upper_arm_r", {10, 0, 0}}, {"forearm_r", {-4, 0, 0}},
       {"thigh_l", {-8, 4, 0}}, {"shank_l", {5, 0, 0}}, {"tail1", {-40, 0, 0}},
       {"tail2", {-30, 0, 0}}, {"tail3", {-22, 6, 0}}, {"tail4", {26, 0, 0}}},
      // 4: full gallop, stretched
      {{"pelvis", {-3, 0, 0}},      {"loin", {3, 0, 0}},        {"chest", {4, 0, 0}},
       {"upper_arm_r", {52, 0, 0}}, {"forearm_r", {14, 0, 0}},  {"forepaw_r", {-18, 0, 0}},
       {"upper_arm_l", {38, 0, 0}}, {"forearm_l", {24, 0, 0}},  {"forepaw_l", {-38, 0, 0}},
       {"thigh_r", {-44, 0, 0}},    {"shank_r", {14, 0, 0}},    {"hock_r", {-18, 0, 0}},
       {"hindpaw_r", {-12, 0, 0}},  {"thigh_l", {-34, 0, 0}},   {"shank_l", {6, 0, 0}},
       {"hock_l", {-12, 0, 0}},     {"hindpaw_l", {-16, 0, 0}}, {"neck", {-26, 0, 0}},
       {"nape", {-8, 0, 0}},        {"head", {18, 0, 0}},       {"tail1", {-6, 0, 0}},
       {"tail2", {-10, 0, 0}},      {"tail3", {-12, 0, 0}}},
      // 5: gallop, gathered, back arched
      {{"pelvis", {10, 0, 0}},       {"loin", {-20, 0, 0}},     {"chest", {-16, 0, 0}},
       {"upper_arm_r", {-22, 0, 0}}, {"forearm_r", {22, 0, 0}}, {"forepaw_r", {-66, 0, 0}},
       {"upper_arm_l", {-10, 0, 0}}, {"forearm_l", {-6, 0, 0}}, {"forepaw_l", {-26, 0, 0}},
       {"thigh_r", {30, 18, 0}},     {"shank_r", {-6, 0, 0}},   {"hock_r", {12, 0, 0}},
       {"hindpaw_r", {-8, 0, 0}},    {"thigh_l", {22, 17, 0}},  {"shank_l", {-2, 0, 0}},
       {"hock_l", {6, 0, 0}},        {"hindpaw_l", {-4, 0, 0}}, {"neck", {2, 0, 0}},
       {"nape", {4, 0, 0}},          {"head", {10, 0, 0}},      {"tail1", {6, 0, 0}},
       {"tail2", {-14, 0, 0}}},
      // 6: head down, sniffing the ground
      {{"chest", {-8, 0, 0}}, {"neck", {-58, 6, 0}}, {"nape", {-30, 8, 0}}, {"head", {20, 6, 0}},
       {"upper_arm_r", {20, 2, 0}}, {"forearm_r", {-4, 0, 0}}, {"upper_arm_l", {-12, 2, 0}},
       {"forearm_l", {2, 0, 0}}, {"thigh_r", {-6, 0, 0}}, {"thigh_l", {10, 0, 0}},
       {"shank_l", {-8, 0, 0}}, {"tail1", {-18, -10, 0}}, {"tail2", {-14, -8, 0}}},
      // 7: offering the right forepaw, looking up
      {{"upper_arm_r", {52, 4, 0}}, {"forearm_r", {48, 0, 0}}, {"forepaw_r", {-44, 0, 0}},
       {"neck", {14, 8, 0}}, {"nape", {8, 6, 0}}, {"head", {16, 8, 6}}, {"upper_arm_l", {-4, 0, 0}},
       {"thigh", {-6, 2, 0}}, {"tail1", {-30, 24, 0}}, {"tail2", {-20, 18, 0}},
       {"tail3", {-10, 12, 0}}},
      // 8: play bow, forelegs stretched on the ground
      {{"pelvis", {-30, 0, 0}}, {"loin", {5, 0, 0}}, {"chest", {10, 0, 0}},
       {"upper_arm", {50, 5, 0}}, {"forearm", {38, 0, 0}}, {"forepaw", {-2, 0, 0}},
       {"neck", {26, 10, 0}}, {"nape", {10, 8, 0}}, {"head", {0, 6, 8}}, {"thigh", {26, 4, 0}},
       {"shank", {6, 0, 0}}, {"hock", {-4, 0, 0}}, {"hindpaw", {2, 0, 0}}, {"tail1", {-50, -12, 0}},
       {"tail2", {-30, -16, 0}}, {"tail3", {-10, -16, 0}}},
      // 9: right hind leg lifted aside
      {{"pelvis", {0, 0, 8}}, {"loin", {0, 8, 4}}, {"thigh_r", {12, 56, 0}},
       {"shank_r", {-26, 0, 0}}, {"hock_r", {22, 0, 0}}, {"thigh_l", {-4, 8, 0}},
       {"upper_arm_r", {4, 6, 0}}, {"upper_arm_l", {-10, 6, 0}}, {"neck", {6, 26, 0}},
       {"nape", {0, 20, 0}}, {"head", {-8, 20, 0}}, {"tail1", {-30, -16, 0}},
       {"tail2", {-26, 0, 0}}},
  };
  // clang-format on
  return POSES;
}

}  // namespace posture::synthesis
