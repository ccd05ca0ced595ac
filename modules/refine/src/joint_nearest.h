// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/types.h>

#include <vector>

namespace posture {

/// For each row of `a` the nearest row of `b`, and the other way round; of equally near ones the
/// first. A row that is not finite is nobody's nearest, and has any row.
void nearestBothWays(const Eigen::Ref<const Eigen::MatrixXf>& a,
                     const Eigen::Ref<const Eigen::MatrixXf>& b,
                     std::vector<int>& forward,
                     std::vector<int>& backward);

/// Keeps the leading principal directions of the rows of `a`, on both: distances between rows of
/// different matrices hardly change, and cost less.
void reduceDimensions(Eigen::MatrixXf& a, Eigen::MatrixXf& b, int dimensions);

}  // namespace posture
