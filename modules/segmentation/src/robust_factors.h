// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/median.h>

#include <algorithm>
#include <vector>

namespace posture {

/// Factors on the weights of what is that far off, squared (Geman and McClure).
inline std::vector<double> robustFactors(const std::vector<double>& off) {
  constexpr double LEAST = 1e-20;  // exact where it is all rigid
  const double typical = std::max(median(off), LEAST);
  std::vector<double> factors;
  for (const double o : off) {
    const double ratio = 1 + o / typical;
    factors.push_back(1 / (ratio * ratio));
  }
  return factors;
}

}  // namespace posture
