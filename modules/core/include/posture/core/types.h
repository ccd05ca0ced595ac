// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <cstdint>

// Matrices are made on one side of the interface and freed on the other.
#ifdef POSTURE_EIGEN_MAX_ALIGN_BYTES
static_assert(
    EIGEN_MAX_ALIGN_BYTES == POSTURE_EIGEN_MAX_ALIGN_BYTES &&
        EIGEN_MALLOC_ALREADY_ALIGNED == POSTURE_EIGEN_MALLOC_ALREADY_ALIGNED,
    "With these flags (-march, -mavx, -fsanitize=address) Eigen allocates otherwise than in "
    "the posture libraries: see docs/installing.md, Compiler flags");
#endif

namespace posture {

using Points = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;  ///< n x 3
using Faces = Eigen::Matrix<int, Eigen::Dynamic, 3, Eigen::RowMajor>;      ///< m x 3, CCW, 0-based
using Colors = Eigen::Matrix<std::uint8_t, Eigen::Dynamic, 3, Eigen::RowMajor>;  ///< n x 3, RGB
using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

/// Large tables of lengths or weights, one row a landmark. Single precision: a length is known to
/// a fraction of an edge, and the table of a 25,000-vertex mesh would not fit twice as wide.
using Table = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

struct TriangleMesh {
  Points vertices;
  Faces faces;
};

}  // namespace posture
