// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "skeleton.h"

namespace posture::synthesis {

// Degrees {flex, side, twist}. Flex bends the trunk forward and swings limbs forward (a knee bends
// by a negative one); side raises an arm, spreads a leg, leans the trunk to the left; twist turns
// the trunk to the left.
const std::vector<PoseTable>& humanPoses() {
  // clang-format off
  static const std::vector<PoseTable> POSES = {
      // 1: walking
      {{"thigh_r", {28, 0, 0}}, {"shin_r", {-10, 0, 0}}, {"foot_r", {6, 0, 0}},
       {"thigh_l", {-18, 0, 0}}, {"shin_l", {-22, 0, 0}}, {"foot_l", {-12, 0, 0}},
       {"clavicle", {0, -4, 0}}, {"upper_arm_r", {-24, -22, 0}}, {"forearm_r", {16, 0, 0}},
       {"upper_arm_l", {28, -26, 0}}, {"forearm_l", {30, 0, 0}}, {"waist", {2, 0, 5}},
       {"chest", {2, 0, 5}}, {"head", {0, 0, -6}}},
      // 2: sitting, hands towards the knees
      {{"thigh", {78, 9, 0}}, {"shin", {-78, 0, 0}}, {"waist", {8, 0, 0}}, {"chest", {6, 0, 0}},
       {"upper_arm", {32, -26, 0}}, {"forearm", {40, 0, 0}}, {"hand", {0, 14, 0}},
       {"head", {8, 0, 12}}},
      // 3: both arms raised
      {{"clavicle", {0, 20, 0}}, {"upper_arm_r", {6, 84, 0}}, {"forearm_r", {18, 0, 0}},
       {"upper_arm_l", {10, 74, 0}}, {"forearm_l", {34, 0, 0}}, {"chest", {-6, 0, 0}},
       {"neck", {-10, 0, 0}}, {"head", {-12, 0, 0}}, {"thigh", {0, 6, 0}}},
      // 4: looking round to the left
      {{"waist", {0, 3, 17}}, {"chest", {0, 2, 18}}, {"neck", {0, 0, 26}}, {"head", {4, 0, 30}},
       {"upper_arm_r", {20, -24, 0}}, {"forearm_r", {34, 0, 0}}, {"upper_arm_l", {-18, -14, 0}},
       {"forearm_l", {22, 0, 0}}, {"thigh_l", {-6, 8, -12}}, {"thigh_r", {8, 4, 0}},
       {"shin_r", {-14, 0, 0}}, {"foot_r", {6, 0, 0}}},
      // 5: lunging and reaching forward with the right arm
      {{"pelvis", {10, 0, 0}}, {"waist", {12, 0, 8}}, {"chest", {10, 0, 12}},
       {"neck", {-10, 0, -8}}, {"head", {-12, 0, -6}}, {"clavicle_r", {20, 6, 0}},
       {"upper_arm_r", {84, 20, 0}}, {"forearm_r", {10, 0, 0}}, {"upper_arm_l", {-30, -14, 0}},
       {"forearm_l", {46, 0, 0}}, {"thigh_r", {58, 2, 0}}, {"shin_r", {-56, 0, 0}},
       {"foot_r", {0, 0, 0}}, {"thigh_l", {-22, 2, 0}}, {"shin_l", {-18, 0, 0}},
       {"foot_l", {4, 0, 0}}},
      // 6: right knee raised, arms out for balance
      {{"thigh_r", {80, 6, 0}}, {"shin_r", {-84, 0, 0}}, {"foot_r", {-18, 0, 0}},
       {"thigh_l", {0, -2, 0}}, {"clavicle", {0, 8, 0}}, {"upper_arm_r", {0, 34, 0}},
       {"upper_arm_l", {8, 42, 0}}, {"forearm_l", {16, 0, 0}}, {"waist", {4, -4, 0}},
       {"head", {6, 0, 0}}},
      // 7: bending down, arms hanging
      {{"pelvis", {24, 0, 0}}, {"waist", {32, 0, 0}}, {"chest", {26, 0, 0}}, {"neck", {10, 0, 0}},
       {"head", {12, 0, 0}}, {"thigh", {20, 2, 0}}, {"shin", {2, 0, 0}}, {"clavicle", {12, 0, 0}},
       {"upper_arm_r", {66, -20, 0}}, {"upper_arm_l", {58, -18, 0}}, {"forearm", {10, 0, 0}}},
      // 8: waving with the right hand, left hand at the hip
      {{"clavicle_r", {0, 12, 0}}, {"upper_arm_r", {8, 36, 75}}, {"forearm_r", {86, 0, 0}},
       {"hand_r", {0, 0, 0}}, {"upper_arm_l", {-20, 4, -52}}, {"forearm_l", {82, 0, 0}},
       {"hand_l", {0, 0, 0}}, {"waist", {0, 5, 0}}, {"chest", {0, 5, 0}}, {"head", {0, -8, -10}},
       {"thigh_r", {4, 10, 0}}, {"shin_r", {-4, 0, 0}}, {"thigh_l", {0, 2, 0}}},
      // 9: squatting, arms forward
      {{"pelvis", {12, 0, 0}}, {"waist", {14, 0, 0}}, {"chest", {8, 0, 0}}, {"head", {-22, 0, 0}},
       {"thigh", {72, 20, 0}}, {"shin", {-80, 0, 0}}, {"foot", {24, 0, 0}},
       {"clavicle", {14, 4, 0}}, {"upper_arm", {72, 14, 0}}, {"forearm", {16, 0, 0}}},
  };
  // clang-format on
  return POSES;
}

}  // namespace posture::synthesis
