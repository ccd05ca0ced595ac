// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "motion_json.h"

#include <utility>

namespace posture::app {

Json toJson(const Eigen::Isometry3d& motion) {
  const Eigen::Matrix3d turn = motion.rotation();
  const Eigen::Quaterniond q(turn);
  auto rows = Json::array();
  for (int i = 0; i < 3; ++i) rows.push_back({turn(i, 0), turn(i, 1), turn(i, 2)});
  const Eigen::Vector3d move = motion.translation();
  return {{"rotation", std::move(rows)},
          {"quaternion_wxyz", {q.w(), q.x(), q.y(), q.z()}},
          {"translation", {move[0], move[1], move[2]}}};
}

}  // namespace posture::app
