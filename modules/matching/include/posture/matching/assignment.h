// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/types.h>

#include <vector>

namespace posture {

using CostMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// A one-to-one choice of columns for rows, with the proof that none is cheaper.
struct Assignment {
  std::vector<int>
      column_of_row;  ///< r; -1 for rows left over when there are more rows than columns
  double cost = 0;    ///< the sum of the chosen entries
  /// Dual variables: cost(i, j) >= row_dual[i] + column_dual[j], with equality where chosen; a dual
  /// of the longer side is <= 0, and 0 where it is left over. Their sum is the cost.
  Vector row_dual;
  Vector column_dual;
};

/// The assignment of min(r, c) rows to columns with the least sum: augmenting row reduction, then
/// shortest augmenting paths (Jonker and Volgenant 1987; rectangular as in Crouse 2016). Exact up
/// to rounding. O(min(r, c)^2 max(r, c)).
/// \param cost  r x c, finite, of any sign.
/// \throws std::invalid_argument  an entry is not finite.
Assignment minimumCostAssignment(const CostMatrix& cost);

}  // namespace posture
