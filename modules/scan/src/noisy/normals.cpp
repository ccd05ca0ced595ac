// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "noisy/normals.h"

#include <posture/core/median.h>
#include <posture/core/parallel.h>

#include "noisy/bilateral_weight.h"
#include "points/local_plane.h"
#include "points/spacing.h"
#include <algorithm>
#include <cmath>

namespace posture {
namespace {

constexpr int FEWEST = 8;  ///< neighbours that count at any distance

/// How often planes are fitted again with the normals of the last time.
constexpr int PASSES = 2;

EstimatedNormals planesOfTen(const Points& points,
                             const NeighborTable& neighbors,
                             const Spacing& spacing) {
  const int n = static_cast<int>(points.rows());
  EstimatedNormals estimated{Points(n, 3)};
  std::vector<double> residuals(n), relative(n);
  forEach(n, [&](int i) {
    LocalPlane plane;
    plane.add(Eigen::Vector3d::Zero(), 1);
    constexpr int TEN = 10;
    const int count = std::min(TEN, neighborCount(neighbors, i));
    for (int k = 0; k < count; ++k)
      plane.add((points.row(neighbors(i, k)) - points.row(i)).transpose(), 1);
    const LocalPlane::Fit fit = plane.fit();
    estimated.normals.row(i) = fit.normal;
    residuals[i] = fit.residual;
    relative[i] = fit.residual / spacing.at[i];
  });
  estimated.residual = lowerMedian(std::move(residuals));
  estimated.relative_residual = lowerMedian(std::move(relative));
  return estimated;
}

Points robustPass(const Points& points,
                  const Points& normals,
                  const NeighborTable& neighbors,
                  const Spacing& spacing,
                  double noise) {
  constexpr double HEIGHT_SIGMAS = 2;  // of the noise: a Gaussian that wide
  const int n = static_cast<int>(points.rows());
  Points better(n, 3);
  forEach(n, [&](int i) {
    const Eigen::Vector3d normal = normals.row(i);
    const double sigma = reach(spacing.at[i]), rho = noise * spacing.at[i];
    LocalPlane plane;
    plane.add(Eigen::Vector3d::Zero(), 1);
    for (int k = 0; k < neighbors.cols(); ++k) {
      const int j = neighbors(i, k);
      if (j < 0) break;
      const Eigen::Vector3d offset = (points.row(j) - points.row(i)).transpose();
      const double distance_sq = offset.squaredNorm();
      if (distance_sq > FARTHEST_SQ * sigma * sigma && k >= FEWEST) break;
      const double height = normal.dot(offset), agreement = normal.dot(normals.row(j));
      plane.add(
          offset,
          bilateralWeight(distance_sq, sigma, height, rho, HEIGHT_SIGMAS) * std::pow(agreement, 4));
    }
    better.row(i) = plane.fit().normal;
  });
  return better;
}

}  // namespace

EstimatedNormals estimateNormals(const Points& points,
                                 const NeighborTable& neighbors,
                                 const Spacing& spacing) {
  EstimatedNormals estimated = planesOfTen(points, neighbors, spacing);
  const double noise = noiseReach(estimated.relative_residual);
  for (int pass = 0; pass < PASSES; ++pass)
    estimated.normals = robustPass(points, estimated.normals, neighbors, spacing, noise);
  return estimated;
}

}  // namespace posture
