// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <numeric>
#include <vector>

namespace posture {

/// Union-find that knows of each element whether its sign is that of its root.
class SignedSets {
 public:
  explicit SignedSets(int count) : parent_(count), flipped_(count, 0) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }

  int find(int i) {
    int root = i;
    char flipped = 0;
    for (; parent_[root] != root; root = parent_[root]) flipped ^= flipped_[root];
    while (parent_[i] != root && i != root) {
      const int next = parent_[i];
      const char here = flipped_[i];
      parent_[i] = root;
      flipped_[i] = flipped;
      flipped ^= here;
      i = next;
    }
    return root;
  }

  bool isFlipped(int i) {
    find(i);
    return flipped_[i] != 0;
  }

  void join(int i, int j, bool opposed) {
    const int a = find(i), b = find(j);
    if (a == b) return;
    const char between = static_cast<char>(flipped_[i] ^ flipped_[j] ^ static_cast<char>(opposed));
    // The lower root stays: the result does not depend on the order of equal unions.
    parent_[std::max(a, b)] = std::min(a, b);
    flipped_[std::max(a, b)] = between;
  }

 private:
  std::vector<int> parent_;
  std::vector<char> flipped_;
};

}  // namespace posture
