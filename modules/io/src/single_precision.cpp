// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "single_precision.h"

#include <algorithm>
#include <limits>

namespace posture {

bool fitFloats(const Points& points) {
  constexpr double MOST = 1e-5;  // of the longest side of the box around them
  double moved = 0;
  Eigen::RowVector3d low = Eigen::RowVector3d::Constant(std::numeric_limits<double>::infinity());
  Eigen::RowVector3d high = -low;
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const Eigen::RowVector3d point = points.row(i);
    if (!point.allFinite()) continue;
    moved = std::max(moved, (point - point.cast<float>().cast<double>()).cwiseAbs().maxCoeff());
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  return moved == 0 || moved <= (MOST * high - MOST * low).maxCoeff();
}

}  // namespace posture
