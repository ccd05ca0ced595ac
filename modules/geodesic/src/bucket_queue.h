// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace posture {

/// How distances are shared out to buckets, which are used in turn.
struct BucketRing {
  double per_length = 0;  ///< buckets in a unit of length
  std::size_t size = 1;   ///< a power of two; at least 3 more than any one push lies ahead
};

/// The vertices a front has touched, nearest first, equally near ones by number: buckets of equal
/// width (Dial 1969), of which only the nearest one, the open one, is kept in order, as a heap.
/// Push and pop take constant time while few vertices share a bucket, and a heap's when all do. A
/// vertex whose distance falls is pushed again; the entry it leaves behind is passed over.
class BucketQueue {
 public:
  /// The queue must be empty.
  void start(const BucketRing& ring) {
    per_length_ = ring.per_length;
    first_.resize(ring.size, -1);
    open_ = 0;
  }

  void push(double distance, int vertex) {
    const auto bucket = static_cast<std::int64_t>(distance * per_length_);
    if (bucket <= open_) {
      heap_.push_back({distance, vertex});
      std::push_heap(heap_.begin(), heap_.end());
      return;
    }
    ++waiting_;
    int node = unused_;
    if (node < 0) {
      node = static_cast<int>(nodes_.size());
      nodes_.emplace_back();
    } else {
      unused_ = nodes_[node].next;
    }
    nodes_[node] = {{distance, vertex}, std::exchange(firstOf(bucket), node)};
  }

  /// The next vertex; -1 where none is left. `distance` has what was last pushed for each vertex,
  /// something else where it is not wanted any more.
  int pop(const std::vector<double>& distance) {
    while (true) {
      while (heap_.empty()) {
        if (waiting_ == 0) return -1;
        openNext(distance);
      }
      std::pop_heap(heap_.begin(), heap_.end());
      const Entry top = heap_.back();
      heap_.pop_back();
      if (top.distance == distance[top.vertex]) return top.vertex;
    }
  }

 private:
  struct Entry {
    double distance;
    int vertex;

    /// The standard heap keeps the largest on top.
    bool operator<(const Entry& that) const {
      return distance != that.distance ? distance > that.distance : vertex > that.vertex;
    }
  };

  struct Node {
    Entry entry;
    int next;
  };

  int& firstOf(std::int64_t bucket) { return first_[bucket & (first_.size() - 1)]; }

  void openNext(const std::vector<double>& distance) {
    int& first = firstOf(++open_);
    while (first >= 0) {
      Node& node = nodes_[first];
      if (node.entry.distance == distance[node.entry.vertex]) heap_.push_back(node.entry);
      const int next = node.next;
      node.next = std::exchange(unused_, first);
      first = next;
      --waiting_;
    }
    if (heap_.size() > 1) std::make_heap(heap_.begin(), heap_.end());
  }

  double per_length_ = 0;
  std::vector<int> first_;   // by bucket modulo the ring: the first node of its list, or -1
  std::vector<Node> nodes_;  // of all lists
  int unused_ = -1;          // the first node of the list of those in no bucket
  int waiting_ = 0;          // nodes in buckets
  std::vector<Entry> heap_;  // what the open bucket held and holds
  std::int64_t open_ = 0;    // its number; all before it are empty
};

}  // namespace posture
