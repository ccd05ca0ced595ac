// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/mesh/moment_axes.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

namespace posture {

Eigen::Matrix3d momentAxes(const Points& points, const Vector& weights) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(points.transpose() *
                                                              weights.asDiagonal() * points);
  Eigen::Matrix3d axes = solver.eigenvectors();
  // A rotation leaves two of the signs free; the two clearest third moments set them.
  const Points along = points * axes;
  const Eigen::Vector3d skewness =
      (weights.transpose() * along.array().cube().matrix())
          .transpose()
          .cwiseQuotient(solver.eigenvalues().cwiseMax(1e-200).array().pow(1.5).matrix());
  int least = 0;
  skewness.cwiseAbs().minCoeff(&least);
  for (int k = 0; k < 3; ++k)
    if (k != least && skewness[k] < 0) axes.col(k) *= -1;
  if (axes.determinant() < 0) axes.col(least) *= -1;
  return axes;
}

}  // namespace posture
