// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <vector>

namespace posture {

/// The best first. \tparam Scored  with a MapScore `score`.
template <class Scored>
void sortByScore(std::vector<Scored>& maps) {
  std::stable_sort(maps.begin(), maps.end(), [](const Scored& a, const Scored& b) {
    return a.score.total() < b.score.total();
  });
}

}  // namespace posture
