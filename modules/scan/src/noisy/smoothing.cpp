// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "noisy/smoothing.h"

#include <posture/core/parallel.h>

#include "noisy/bilateral_weight.h"

namespace posture {
namespace {

/// How often each point is moved.
constexpr int PASSES = 2;

/// Of normals: a neighbour whose own differs by more, 73 degrees, is on another sheet.
constexpr double LEAST_AGREEMENT = 0.3;

/// Of the noise: a Gaussian of heights that wide.
constexpr double HEIGHT_SIGMAS = 3;

OrientedPoints smoothed(const OrientedPoints& given,
                        const NeighborTable& neighbors,
                        const Spacing& spacing,
                        double noise) {
  OrientedPoints result = given;
  forEach(static_cast<int>(given.points.rows()), [&](int i) {
    const Eigen::RowVector3d point = given.points.row(i), normal = given.normals.row(i);
    Eigen::RowVector3d normal_sum = normal;
    const double sigma = reach(spacing.at[i]), rho = noise * spacing.at[i];
    double weight_sum = 1, shift = 0;
    for (int j : neighbors.row(i)) {
      if (j < 0) break;
      const Eigen::RowVector3d offset = point - given.points.row(j);
      const double distance_sq = offset.squaredNorm();
      if (distance_sq > FARTHEST_SQ * sigma * sigma) break;
      const double agreement = normal.dot(given.normals.row(j));
      if (agreement < LEAST_AGREEMENT) continue;
      const double height = (normal + given.normals.row(j)).dot(offset) / 2;
      const double weight =
          bilateralWeight(distance_sq, sigma, height, rho, HEIGHT_SIGMAS) * agreement * agreement;
      shift += weight * height;
      normal_sum += weight * given.normals.row(j);
      weight_sum += weight;
    }
    result.points.row(i) -= shift / weight_sum * normal;
    result.normals.row(i) = normal_sum.normalized();
  });
  return result;
}

}  // namespace

void smooth(const NeighborTable& neighbors,
            const Spacing& spacing,
            double residual,
            OrientedPoints& oriented) {
  for (int pass = 0; pass < PASSES; ++pass)
    oriented = smoothed(oriented, neighbors, spacing, noiseReach(residual));
}

}  // namespace posture
