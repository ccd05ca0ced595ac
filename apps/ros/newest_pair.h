// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/point_cloud.h>

#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <sensor_msgs/PointCloud2.h>

namespace posture::app {

/// One side: a message, and of a file the shape it was made from.
struct Side {
  sensor_msgs::PointCloud2ConstPtr message;
  std::shared_ptr<const Shape> shape;
};

struct Pair {
  Side source, target;
};

/// Hands what came last from the callbacks to the one thread that registers. No member but take()
/// waits.
class NewestPair {
 public:
  /// Makes a pair with the newest target, in place of any that waits.
  void setSource(const Side& source);
  void setTarget(const Side& target);

  /// The newest pair once more. false: one side has never come.
  bool again();

  /// Waits for the next pair; none after close().
  std::optional<Pair> take();

  /// Of the pair taken last only one side was new, and the other has come since: its result would
  /// be of two clouds that do not belong together. The pair taken next is never outdated: whatever
  /// comes, every other pair is registered to its end.
  bool outdated() const;

  void close();
  bool closed() const;

 private:
  struct Slot {
    Side side;
    bool waits = false;    // came after the last take()
    bool was_new = false;  // no pair but the last has it, save one that was given up
  };
  void set(Slot& slot, const Side& side);
  bool complete() const;
  bool outdatedUnlocked() const;

  mutable std::mutex mutex_;
  std::condition_variable changed_;
  Slot source_, target_;
  bool again_ = false, closed_ = false;
};

}  // namespace posture::app
