// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <Eigen/QR>

#include "points/local_plane.h"
#include "points/neighbors.h"
#include <cmath>

namespace posture {

/// Root mean square distance of a point and its COUNT nearest neighbours from the quadric that fits
/// them best, per degree of freedom.
template <int COUNT>
double quadricResidual(const Points& points, const NeighborTable& neighbors, int i) {
  constexpr int TERMS = 6;
  using Column = Eigen::Matrix<double, COUNT + 1, 1>;
  Eigen::Matrix<double, COUNT + 1, 3> around = Eigen::Matrix<double, COUNT + 1, 3>::Zero();
  LocalPlane plane;
  for (int k = 0; k < COUNT; ++k) around.row(k) = points.row(neighbors(i, k)) - points.row(i);
  for (int k = 0; k <= COUNT; ++k) plane.add(around.row(k).transpose(), 1);
  const Eigen::Vector3d normal = plane.fit().normal, u = normal.unitOrthogonal();
  // Of the size of one: the powers then are, too.
  const double size = around.rowwise().norm().maxCoeff();
  const Column x = around * u / size, y = around * normal.cross(u) / size, z = around * normal;
  Eigen::Matrix<double, COUNT + 1, TERMS> terms;
  terms << Column::Ones(), x, y, x.cwiseProduct(x), x.cwiseProduct(y), y.cwiseProduct(y);
  const Eigen::Matrix<double, TERMS, 1> quadric = terms.colPivHouseholderQr().solve(z);
  return (z - terms * quadric).norm() / std::sqrt(COUNT + 1.0 - TERMS);
}

}  // namespace posture
