// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/types.h>

#include <Eigen/SparseCore>

#include <vector>

namespace posture {

/// x, y, z and a fourth, which is 0: what a register of AVX2 holds.
struct alignas(4 * sizeof(double)) WideRow {
  double at[4];
};

struct WideMatrix {
  WideRow column[3];
};

std::vector<WideRow> wideRows(const Points& points);
Points narrowRows(const std::vector<WideRow>& rows);
WideMatrix wide(const Eigen::Matrix3d& matrix);

inline Eigen::Matrix3d narrow(const WideMatrix& matrix) {
  Eigen::Matrix3d m;
  for (int k = 0; k < 3; ++k) m.col(k) = Eigen::Map<const Eigen::Vector3d>(matrix.column[k].at);
  return m;
}

/// An edge of positive weight; looked at once for both its ends.
struct RigidEdge {
  int i, j;  ///< i < j
  double weight;
  Eigen::RowVector3d rest;  ///< from j to i
};

/// What Arap::pull() does over and over, a vertex a row. AVX2 is used where the processor has it,
/// to the same last digit, as no multiplication is fused.
struct ArapSteps {
  /// Adds to the matrix of each vertex, over its edges, weight * (the edge as it lies)' (at rest).
  void (*addCovariances)(const std::vector<RigidEdge>& edges,
                         const std::vector<WideRow>& places,
                         std::vector<WideMatrix>& matrices);

  /// Adds the right-hand side that the edges at rest make, each turned by the mean of its ends'
  /// rotations times their stiffness.
  void (*addRigidPull)(const std::vector<RigidEdge>& edges,
                       const std::vector<WideMatrix>& rotations,
                       const Vector& stiffness,
                       std::vector<WideRow>& pull);

  /// Solves L D L' x = b for all columns at once. \param lower  L without its diagonal of ones.
  void (*solve)(const Eigen::SparseMatrix<double>& lower,
                const Vector& inverse_diagonal,
                std::vector<WideRow>& b_then_x);
};

const ArapSteps& arapSteps();

/// What is done where the processor has no AVX2.
const ArapSteps& portableArapSteps();

}  // namespace posture
