// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "noisy/smoothing.h"

#include <posture/core/parallel.h>

#include <cmath>

namespace posture {
namespace {

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
      if (distance_sq > 6.25 * sigma * sigma) break;
      const double agreement = normal.dot(given.normals.row(j));
      if (agreement < 0.3) continue;
      const double height = (normal + given.normals.row(j)).dot(offset) / 2;
      const double weight =
          std::exp(-distance_sq / (2 * sigma * sigma) - height * height / (18 * rho * rho)) *
          agreement * agreement;
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
  for (int pass = 0; pass < 2; ++pass)
    oriented = smoothed(oriented, neighbors, spacing, noiseReach(residual));
}

}  // namespace posture
