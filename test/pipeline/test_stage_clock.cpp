// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/error.h>

#include <gtest/gtest.h>

#include "stage_clock.h"
#include <stdexcept>
#include <string>
#include <vector>

namespace posture {
namespace {

/// What an observer ends a run with.
struct Stopped : InputError {
  Stopped() : InputError("stopped") {}
};

int tooLittle() { throw InputError("too little surface"); }

TEST(StageClock, anAttemptThatFailsLeavesTheEarlierAnswer) {
  std::vector<std::string> attempts;
  const Observer observer = [&](const StageEvent& event) { attempts.emplace_back(event.attempt); };
  StageClock clock(observer);
  int answer = clock.stage("spectrum", 0.1, [] { return 1; });
  const auto attempt = [&](auto work) {
    if (const auto other =
            clock.tryAttempt("patched", 0.5, [&] { return clock.stage("spectrum", 0.1, work); }))
      answer = *other;
  };
  attempt(tooLittle);
  EXPECT_EQ(answer, 1);
  clock.stage("completion", 0.1, [] {});
  EXPECT_EQ(attempts, (std::vector<std::string>{"", "patched", ""})) << "its label ends with it";
  EXPECT_EQ(clock.timings().size(), 2U);
  attempt([]() -> int { throw NoWayOn("nothing is mapped"); });
  EXPECT_EQ(answer, 1);
  attempt([] { return 2; });
  EXPECT_EQ(answer, 2);
}

TEST(StageClock, whatTheObserverThrowsEndsTheRun) {
  const Observer observer = [](const StageEvent& event) {
    if (event.stage == "spectrum") throw Stopped();
  };
  StageClock clock(observer);
  const auto inner = [&] {
    return clock.tryTo([&] { return clock.stage("spectrum", 0.1, [] { return 1; }); });
  };
  EXPECT_THROW(clock.tryAttempt("piece-1", 0.5, inner), Stopped);
}

TEST(StageClock, nothingElseThatIsThrownIsTakenForTooLittle) {
  const Observer none;
  StageClock clock(none);
  EXPECT_THROW(clock.tryTo([]() -> int { throw std::invalid_argument("sizes"); }),
               std::invalid_argument);
  EXPECT_THROW(clock.tryTo([]() -> int { throw std::runtime_error("a library's"); }),
               std::runtime_error);
}

}  // namespace
}  // namespace posture
