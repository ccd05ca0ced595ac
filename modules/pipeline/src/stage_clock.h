// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/pipeline/observer.h>
#include <posture/pipeline/register_shapes.h>

#include <chrono>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace posture {

/// Times the stages of a run and tells the observer of them.
class StageClock {
 public:
  explicit StageClock(const Observer& observer) : observer_(observer) {}

  /// Runs one stage; `share` is its usual part of the time; all shares of a
  /// run, of clouds too, come to at most 1.
  template <class Work>
  auto stage(const std::string& name, double share, const Work& work) {
    if (observer_) observer_({name, progress_, {}});
    const auto start = std::chrono::steady_clock::now();
    auto result = work();
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
    timings_.push_back({name, elapsed.count()});
    progress_ += share;
    return result;
  }

  /// Hands the pictures of the stage just run to the observer.
  void show(const std::function<std::vector<StagePicture>()>& pictures) const {
    if (observer_ && !timings_.empty()) observer_({timings_.back().stage, progress_, pictures});
  }

  const std::vector<StageTiming>& timings() const { return timings_; }

 private:
  const Observer& observer_;
  std::vector<StageTiming> timings_;
  double progress_ = 0;
};

}  // namespace posture
