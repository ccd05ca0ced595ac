// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

namespace posture {

/// The cheapest way to part a graph into what goes with a source and what goes with a sink. Amounts
/// are not negative.
class MinimumCut {
 public:
  explicit MinimumCut(int nodes) : source_(nodes), sink_(nodes + 1) {}

  /// Costs `amount` to have a node on the side of the sink.
  void joinSource(int node, double amount) { joins_.push_back({source_, node, amount, 0}); }

  /// Costs `amount` to have a node on the side of the source.
  void joinSink(int node, double amount) { joins_.push_back({node, sink_, amount, 0}); }

  /// Costs `amount` to have two nodes on different sides.
  void join(int a, int b, double amount) { joins_.push_back({a, b, amount, amount}); }

  /// Of each node whether it is on the side of the sink. Boykov and Kolmogorov, An experimental
  /// comparison of min-cut/max-flow algorithms for energy minimization in vision, 2004.
  std::vector<char> onSinkSide() const;

 private:
  struct Join {
    int a, b;
    double there, back;
  };

  int source_, sink_;
  std::vector<Join> joins_;
};

}  // namespace posture
