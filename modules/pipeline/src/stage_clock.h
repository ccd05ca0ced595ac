// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/error.h>
#include <posture/core/seconds_since.h>
#include <posture/pipeline/observer.h>
#include <posture/pipeline/register_shapes.h>

#include "no_way_on.h"
#include <algorithm>
#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <type_traits>
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
    tell({label_.attempt, name, progress(), {}});
    const auto start = std::chrono::steady_clock::now();
    const auto end = [&] {
      timings_.push_back({label_.attempt, name, secondsSince(start)});
      progress_ += label_.portion * share;
    };
    if constexpr (std::is_void_v<decltype(work())>) {
      work();
      end();
    } else {
      auto result = work();
      end();
      return result;
    }
  }

  /// Progress over stages that are not needed.
  void skip(double share) { progress_ += label_.portion * share; }

  /// Hands the pictures of the stage just run to the observer.
  void show(const std::function<std::vector<StagePicture>()>& pictures) {
    if (!timings_.empty()) tell({label_.attempt, timings_.back().stage, progress(), pictures});
  }

  /// The attempt that stages belong to, and what their shares count by.
  struct Label {
    std::string attempt;  ///< "": as given
    double portion = 1;
  };
  const Label& label() const { return label_; }

  /// Runs stages under a label.
  template <class Work>
  auto within(const Label& label, const Work& work) {
    const Scope scope(*this, label);
    return work();
  }

  /// Runs a further attempt, which may find too little to work on: none then.
  template <class Work>
  auto tryAttempt(const std::string& name, double portion, const Work& work)
      -> std::optional<decltype(work())> {
    return tryTo([&] { return within({name, portion}, work); });
  }

  /// Runs what may find too little to work on (InputError, NoWayOn): none then.
  template <class Work>
  auto tryTo(const Work& work) -> std::optional<decltype(work())> {
    const auto none = [&] {
      if (is_observer_speaking_) throw;  // it was the observer: it wants the run to end
      return std::nullopt;
    };
    try {
      return work();
    } catch (const InputError&) {
      return none();
    } catch (const NoWayOn&) {
      return none();
    }
  }

  const std::vector<StageTiming>& timings() const { return timings_; }

 private:
  struct Scope {
    Scope(StageClock& clock_in, const Label& label) : clock(clock_in), before(clock.label_) {
      clock.label_ = label;
    }
    ~Scope() { clock.label_ = before; }
    Scope(const Scope&) = delete;
    Scope& operator=(const Scope&) = delete;
    StageClock& clock;
    Label before;
  };

  /// Stages of an attempt that cannot be finished count, and so do those made in their place.
  double progress() const { return std::min(1.0, progress_); }

  void tell(const StageEvent& event) {
    if (!observer_) return;
    is_observer_speaking_ = true;  // still so after it threw
    observer_(event);
    is_observer_speaking_ = false;
  }

  const Observer& observer_;
  std::vector<StageTiming> timings_;
  Label label_;
  double progress_ = 0;
  bool is_observer_speaking_ = false;
};

}  // namespace posture
