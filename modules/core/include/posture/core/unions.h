// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <numeric>
#include <vector>

namespace posture {

/// Sets of the numbers from 0 to n - 1 that grow together, at first one each.
class Unions {
 public:
  explicit Unions(int n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0); }

  /// The least number in the set of x.
  int root(int x) {
    while (parent_[x] != x) x = parent_[x] = parent_[parent_[x]];
    return x;
  }

  /// False if they were one set before.
  bool join(int a, int b) {
    a = root(a);
    b = root(b);
    parent_[std::max(a, b)] = std::min(a, b);
    return a != b;
  }

 private:
  std::vector<int> parent_;
};

}  // namespace posture
