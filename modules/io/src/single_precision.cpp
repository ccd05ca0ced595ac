// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "single_precision.h"

#include <algorithm>
#include <limits>
#include <vector>

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

bool differAsFloats(const Points& points) {
  const Eigen::Matrix<float, Eigen::Dynamic, 3, Eigen::RowMajor> single = points.cast<float>();
  std::vector<int> order;  // what is not finite has no place in one
  for (int i = 0; i < single.rows(); ++i)
    if (single.row(i).allFinite()) order.push_back(i);
  std::sort(order.begin(), order.end(), [&](int i, int j) {
    return std::lexicographical_compare(
        single.row(i).begin(), single.row(i).end(), single.row(j).begin(), single.row(j).end());
  });
  for (std::size_t k = 1; k < order.size(); ++k)
    if (single.row(order[k]) == single.row(order[k - 1]) &&
        points.row(order[k]) != points.row(order[k - 1]))
      return false;
  return true;
}

}  // namespace posture
