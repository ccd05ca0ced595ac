// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/types.h>

#include <vector>

namespace posture {

/// A matrix of three columns, such as Points or Faces.
/// \param rows  lists of three numbers, or vectors.
template <class Matrix, class Row>
Matrix matrixOf(const std::vector<Row>& rows) {
  Matrix matrix(static_cast<Eigen::Index>(rows.size()), 3);
  for (Eigen::Index i = 0; i < matrix.rows(); ++i)
    for (int k = 0; k < 3; ++k) matrix(i, k) = rows[static_cast<std::size_t>(i)][k];
  return matrix;
}

}  // namespace posture
