// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

namespace posture {

/// The value below which a share `q` in [0, 1] of the values lies, interpolated between neighbours
/// (0.5: the median); NaN where there are no values.
double percentile(std::vector<double> values, double q);

/// NaN where there are no values.
double mean(const std::vector<double>& values);

/// NaN where there are no values.
double largest(const std::vector<double>& values);

/// At most `limit` of the numbers 0 .. count - 1, evenly spread, increasing.
std::vector<int> evenSubset(int count, int limit);

}  // namespace posture
