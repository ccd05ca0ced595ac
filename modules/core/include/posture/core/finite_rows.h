// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/types.h>

#include <vector>

namespace posture {

/// Numbers of the points that were seen, increasing: the others are not finite.
inline std::vector<int> finiteRows(const Points& points) {
  std::vector<int> rows;
  for (int i = 0; i < points.rows(); ++i)
    if (points.row(i).allFinite()) rows.push_back(i);
  return rows;
}

}  // namespace posture
