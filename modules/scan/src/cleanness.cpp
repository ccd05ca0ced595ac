// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cleanness.h"

#include <posture/core/parallel.h>

#include <Eigen/Geometry>
#include <Eigen/QR>

#include "local_plane.h"
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace posture {
namespace {

constexpr int NEAR = 12, TERMS = 6;

/// Root mean square distance of a point and its neighbours from their quadric, per degree of
/// freedom.
double residual(const Points& points, const NeighborTable& neighbors, int i) {
  Eigen::Matrix<double, NEAR + 1, 3> around = Eigen::Matrix<double, NEAR + 1, 3>::Zero();
  LocalPlane plane;
  for (int k = 0; k < NEAR; ++k) around.row(k) = points.row(neighbors(i, k)) - points.row(i);
  for (int k = 0; k <= NEAR; ++k) plane.add(around.row(k).transpose(), 1);
  const Eigen::Vector3d normal = plane.fit().normal, u = normal.unitOrthogonal();
  // Of the size of one: the powers then are, too.
  const double size = around.rowwise().norm().maxCoeff();
  const Eigen::Matrix<double, NEAR + 1, 1> x = around * u / size,
                                           y = around * normal.cross(u) / size, z = around * normal;
  Eigen::Matrix<double, NEAR + 1, TERMS> terms;
  terms << Eigen::Matrix<double, NEAR + 1, 1>::Ones(), x, y, x.cwiseProduct(x), x.cwiseProduct(y),
      y.cwiseProduct(y);
  const Eigen::Matrix<double, TERMS, 1> quadric = terms.colPivHouseholderQr().solve(z);
  return (z - terms * quadric).norm() / std::sqrt(NEAR + 1.0 - TERMS);
}

}  // namespace

Cleanness cleanness(const Points& points, const NeighborTable& neighbors, const Spacing& spacing) {
  // Of noise alone the second percentile of such residuals, of seven degrees of freedom, is 0.47
  // of the noise and half of the median.
  constexpr double LOW = 0.02, LOW_OF_NOISE = 0.47, LOW_OF_MEDIAN = 0.5;
  // Vertices of meshes have up to 0.06, scans with a noise of a fifth of a pixel 0.1 and more.
  constexpr double LITTLE = 0.08;
  // Turns no face by more than a degree or so.
  constexpr double NEGLIGIBLE = 0.01;
  const int n = static_cast<int>(points.rows()), looked_at = std::min(n, 5000);
  if (neighbors.cols() < NEAR) return {};
  std::vector<double> residuals(looked_at, std::numeric_limits<double>::infinity());
  parallelFor(looked_at, [&](int s) {
    const int i = static_cast<int>(static_cast<std::int64_t>(s) * n / looked_at);
    if (neighborCount(neighbors, i) >= NEAR)
      residuals[s] = residual(points, neighbors, i) / spacing.at[i];
  });
  std::sort(residuals.begin(), residuals.end());
  const double low = residuals[static_cast<std::size_t>(LOW * looked_at)],
               middle = residuals[looked_at / 2], noise = low / LOW_OF_NOISE;
  // What is spread less than that is mostly noise.
  const bool is_uneven = low < 0.8 * LOW_OF_MEDIAN * middle;
  return {noise < NEGLIGIBLE || (noise < LITTLE && is_uneven), noise};
}

}  // namespace posture
