// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace posture {

/// Sets of the numbers from 0 to n - 1 that grow together, at first one each.
class Unions {
 public:
  explicit Unions(int n) : parent_(n), count_(n) { std::iota(parent_.begin(), parent_.end(), 0); }

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
    count_ -= a != b ? 1 : 0;
    return a != b;
  }

  /// How many sets there are.
  int count() const { return count_; }

  /// Of each number, the root.
  std::vector<int> roots() {
    std::vector<int> roots(parent_.size());
    for (std::size_t x = 0; x < roots.size(); ++x) roots[x] = root(static_cast<int>(x));
    return roots;
  }

  /// Of each number, how many are in its set.
  std::vector<int> sizes() {
    std::vector<int> of_root(parent_.size(), 0), sizes = roots();
    for (int r : sizes) ++of_root[r];
    for (int& size : sizes) size = of_root[size];
    return sizes;
  }

 private:
  std::vector<int> parent_;
  int count_;
};

}  // namespace posture
