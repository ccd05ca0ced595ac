// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/mesh/rigid_motion.h>

namespace posture {

Eigen::Isometry3d rigidMotion(const Points& from, const Points& to) {
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
  if (from.rows() == 0) return motion;
  if (from.rows() < 3) {
    motion.translation() = (to.colwise().mean() - from.colwise().mean()).transpose();
    return motion;
  }
  const Eigen::MatrixXd columns_from = from.transpose(), columns_to = to.transpose();
  motion.matrix() = Eigen::umeyama(columns_from, columns_to, false);
  return motion;
}

Points moved(const Eigen::Isometry3d& motion, const Points& points) {
  return (points * motion.linear().transpose()).rowwise() + motion.translation().transpose();
}

}  // namespace posture
