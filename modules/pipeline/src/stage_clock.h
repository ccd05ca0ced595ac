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
    const std::string full_name = attempt_.empty() ? name : attempt_ + " " + name;
    tell({full_name, progress_, {}});
    const auto start = std::chrono::steady_clock::now();
    auto result = work();
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
    timings_.push_back({full_name, elapsed.count()});
    progress_ += portion_ * share;
    return result;
  }

  /// Hands the pictures of the stage just run to the observer.
  void show(const std::function<std::vector<StagePicture>()>& pictures) {
    if (timings_.empty()) return;
    if (attempt_.empty()) return tell({timings_.back().stage, progress_, pictures});
    tell({timings_.back().stage, progress_, [&] {
            std::vector<StagePicture> named = pictures();
            for (StagePicture& picture : named) picture.name = attempt_ + "-" + picture.name;
            return named;
          }});
  }

  /// Runs stages that are one of several attempts at the same: their shares count by `portion`,
  /// and the names of the attempt, if it has one, and of the stage are said together.
  template <class Work>
  auto attempt(const std::string& name, double portion, const Work& work) {
    struct Scope {
      StageClock& clock;
      ~Scope() {
        clock.attempt_.clear();
        clock.portion_ = 1;
      }
    } scope{*this};
    attempt_ = name;
    portion_ = portion;
    return work();
  }

  /// Whether it was the observer that threw: it wants the run to end.
  bool isStopped() const { return stopped_; }

  const std::vector<StageTiming>& timings() const { return timings_; }

 private:
  void tell(const StageEvent& event) {
    if (!observer_) return;
    stopped_ = true;
    observer_(event);
    stopped_ = false;
  }

  const Observer& observer_;
  std::vector<StageTiming> timings_;
  std::string attempt_;
  double progress_ = 0, portion_ = 1;
  bool stopped_ = false;
};

}  // namespace posture
