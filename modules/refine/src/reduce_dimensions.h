// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/types.h>

namespace posture {

/// Keeps the leading principal directions of the rows of `a`, on both: distances between rows of
/// different matrices hardly change, and cost less.
void reduceDimensions(Eigen::MatrixXf& a, Eigen::MatrixXf& b, int dimensions);

}  // namespace posture
