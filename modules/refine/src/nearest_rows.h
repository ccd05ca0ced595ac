// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/types.h>

#include <vector>

namespace posture {

/// For each row of `a` the nearest row of `b`, and the other way round; of equally near ones the
/// first. A row that is not finite is nobody's nearest, and has any row.
void nearestBothWays(const Eigen::MatrixXf& a,
                     const Eigen::MatrixXf& b,
                     std::vector<int>& forward,
                     std::vector<int>& backward);

/// The same for many rows most of which are far from each other, such as places on two surfaces
/// that nearly lie on each other: compares only groups of rows that may hold neighbours.
void nearestAmongGroups(const Eigen::MatrixXf& a,
                        const Eigen::MatrixXf& b,
                        std::vector<int>& forward,
                        std::vector<int>& backward);

}  // namespace posture
