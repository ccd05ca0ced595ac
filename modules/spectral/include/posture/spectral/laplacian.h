// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/types.h>

#include <Eigen/SparseCore>

namespace posture {

/// The Laplace-Beltrami operator of a mesh by linear finite elements (Pinkall and Polthier 1993;
/// Meyer et al. 2003). On a boundary its natural condition holds: no flow across.
struct Laplacian {
  Eigen::SparseMatrix<double> stiffness;  ///< n x n cotangent weights, positive semi-definite
  Vector mass;                            ///< n areas, a third of each adjacent face; > 0
};

Laplacian cotangentLaplacian(const TriangleMesh& mesh);

}  // namespace posture
