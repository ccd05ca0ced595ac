// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "otsu.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace posture {

double otsuThreshold(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const double total = std::accumulate(values.begin(), values.end(), 0.0);
  const auto count = static_cast<double>(values.size());
  double below = 0, most = -1, cut = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < values.size(); ++i) {
    below += values[i - 1];
    const auto k = static_cast<double>(i);
    const double gap = (total - below) / (count - k) - below / k;
    const double between = k * (count - k) * gap * gap;
    if (between <= most) continue;
    most = between;
    cut = 0.5 * (values[i - 1] + values[i]);
  }
  return cut;
}

}  // namespace posture
