// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace posture {

/// Shortest ways from some of n nodes to others, along edges of no negative length (Dijkstra 1959).
/// Each search forgets what the last one reached, and no more.
class ShortestWays {
 public:
  explicit ShortestWays(int n) : distance_(n, FAR), before_(n, -1) {}

  /// Calls arrive(v) for each node in the order of its distance, of several as far the least first,
  /// until that is false.
  ///
  /// \param forEachNext  forEachNext(v, step) calls step(w, length) for each edge that leaves v.
  template <class ForEachNext, class Arrive>
  void search(const std::vector<int>& from, const ForEachNext& forEachNext, const Arrive& arrive) {
    using Entry = std::pair<double, int>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> front;
    for (int v : reached_) {
      distance_[v] = FAR;
      before_[v] = -1;
    }
    reached_.clear();
    const auto reach = [&](int v, double distance, int before) {
      if (distance >= distance_[v]) return;
      if (distance_[v] == FAR) reached_.push_back(v);
      distance_[v] = distance;
      before_[v] = before;
      front.emplace(distance, v);
    };
    for (int v : from) reach(v, 0, -1);
    while (!front.empty()) {
      const double here = front.top().first;
      const int v = front.top().second;
      front.pop();
      if (here > distance_[v]) continue;
      if (!arrive(v)) return;
      forEachNext(v, [&](int w, double length) { reach(w, here + length, v); });
    }
  }

  /// Of the last search; once arrived at, as near as it is. Infinity where no way leads.
  double distance(int v) const { return distance_[v]; }
  const std::vector<double>& distances() const { return distance_; }

  /// The node before on the way; -1 at its first.
  int before(int v) const { return before_[v]; }

 private:
  static constexpr double FAR = std::numeric_limits<double>::infinity();

  std::vector<double> distance_;
  std::vector<int> before_, reached_;
};

}  // namespace posture
