// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/deformation/arap.h>

#include <gtest/gtest.h>

#include "attempts/whole_attempts.h"
#include "no_way_on.h"
#include "pipeline/made_up_answers.h"
#include <optional>

namespace posture {
namespace {

using test::answerWith;

/// An attempt that was begun, leads to one place, and counts how often it is gone on with.
struct Begun {
  Begun(double first_score, double last_score, int place) {
    begun.score = first_score;
    begun.goOn = [=](const KnownAnswer&) {
      ++times;
      if (fails) throw NoWayOn("too torn");
      Attempt attempt{answerWith(last_score, place), {}};
      attempt.finish = [=]() -> RegistrationResult {
        if (cannot_be_finished) throw NoWayOn("too torn");
        return answerWith(last_score, place);
      };
      return std::optional(attempt);
    };
  }
  Begun(const Begun&) = delete;
  Begun& operator=(const Begun&) = delete;

  BegunAttempt begun;
  mutable int times = 0;
  bool fails = false, cannot_be_finished = false;
};

class BetterOf : public testing::Test {
 protected:
  /// The place that the result leads to.
  int placeOf(const Begun& whole, const Begun& cut) {
    const RegistrationResult result = finished(betterOf(whole.begun, cut.begun, nullptr, clock_));
    return result.correspondence.on_target[0].vertex;
  }

 private:
  const Observer nobody_;
  StageClock clock_{nobody_};
};

TEST_F(BetterOf, theOtherIsLeftWhereFirstMapsDecideAndTheLastConvinces) {
  const Begun whole(-11, -12, 1), cut(-9, -13, 2);
  EXPECT_EQ(placeOf(whole, cut), 1);
  EXPECT_EQ(cut.times, 0);
  const Begun worse(-9, -13, 1), better(-11, -12, 2);
  EXPECT_EQ(placeOf(worse, better), 2);
  EXPECT_EQ(worse.times, 0);
}

TEST_F(BetterOf, bothAreGoneOnWithWhereFirstMapsDoNotDecide) {
  const Begun whole(-10, -12, 1), better(-10.5, -12.5, 2), hardly_better(-10.5, -12.05, 2);
  EXPECT_EQ(placeOf(whole, better), 2);
  EXPECT_EQ(whole.times, 1);
  EXPECT_EQ(placeOf(whole, hardly_better), 1);
}

TEST_F(BetterOf, theOtherIsTriedWhereTheFavouriteDoesNotConvince) {
  const Begun whole(-9, -8, 1), cut(-7, -9.5, 2);
  EXPECT_EQ(placeOf(whole, cut), 2);
  const Begun as_given(-7, -9.5, 1), open(-9, -8, 2);
  EXPECT_EQ(placeOf(as_given, open), 1);
}

TEST_F(BetterOf, oneThatCannotBeBentGivesWay) {
  Begun whole(-10, -12, 1), cut(-10, -12, 2);
  whole.fails = true;
  EXPECT_EQ(placeOf(whole, cut), 2);
  cut.fails = true;
  EXPECT_THROW(placeOf(whole, cut), TornSurface);
  whole.fails = false;
  EXPECT_EQ(placeOf(whole, cut), 1);
}

TEST_F(BetterOf, oneThatCannotBeFinishedGivesWay) {
  const Begun whole(-10, -12, 1), left(-7, -12, 1);
  Begun cut(-10, -13, 2);
  cut.cannot_be_finished = true;
  EXPECT_EQ(placeOf(whole, cut), 1);
  EXPECT_EQ(placeOf(left, cut), 1);  // which was not gone on with before
}

}  // namespace
}  // namespace posture
