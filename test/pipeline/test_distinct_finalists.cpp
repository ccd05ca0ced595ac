// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "answer/verdict.h"
#include "pipeline/strip.h"
#include "refined/finalists/distinct_finalists.h"
#include <vector>

namespace posture {
namespace {

using Answers = std::vector<int>;

class DistinctFinalists : public test::StripTest {};

TEST_F(DistinctFinalists, finalistsThatLeadToNearlyTheSamePlaceAreOne) {
  std::vector<Finalist> finalists;
  for (int column : {0, 4, 5, 8, 12, 16, 17, 20}) finalists.push_back(finalist(column));
  EXPECT_EQ(distinctFinalists(finalists, strip_, 0.07), (Answers{0, 1, 3, 4, 5, 7}));
}

TEST_F(DistinctFinalists, allThatWereRefinedAreAmongTheForemost) {
  const Answers distinct{0, 1, 3, 4, 5, 7};
  EXPECT_EQ(foremost(distinct, {0}, 4), (Answers{0, 1, 3, 4}));
  EXPECT_EQ(foremost(distinct, {0, 1, 7}, 4), (Answers{0, 1, 3, 7}));
  EXPECT_EQ(foremost(distinct, {0, 1, 3, 4, 7}, 4), (Answers{0, 1, 3, 4, 7}));
  EXPECT_EQ(foremost(distinct, {0}, 9), distinct);
}

TEST_F(DistinctFinalists, anotherAnswerIsRefinedWhereScoresDoNotDecide) {
  const std::vector<Finalist> near{finalist(0, -12), finalist(0, -11.9), finalist(9, -11.5)};
  EXPECT_EQ(leadingOf(near, {0, 2}), (Answers{0, 2}));
  const std::vector<Finalist> far{finalist(0, -12), finalist(0, -11.9), finalist(9, -10.5)};
  EXPECT_EQ(leadingOf(far, {0, 2}), (Answers{0}));
  EXPECT_EQ(leadingOf({finalist(0, -12)}, {0}), (Answers{0}));
}

TEST_F(DistinctFinalists, oneThatHasLetSomethingGoConvincesOnlyForItself) {
  std::vector<Finalist> finalists{finalist(0, -12), finalist(0, -8)};
  EXPECT_TRUE(anyConvincesWhole(finalists));
  finalists[0].score.let_go = 0.1;
  EXPECT_TRUE(convinces(finalists[0].score.total()));
  EXPECT_FALSE(anyConvincesWhole(finalists));
  finalists.push_back(finalist(9, -9));
  EXPECT_TRUE(anyConvincesWhole(finalists));
  EXPECT_FALSE(anyConvincesWhole({}));
}

TEST_F(DistinctFinalists, anAnswerIsAllButCertainWhereItFitsAndNoOtherComesNear) {
  EXPECT_TRUE(isAllButCertain({finalist(0, -12)}, {0}));
  EXPECT_TRUE(isAllButCertain({finalist(0, -12), finalist(9, -10.5)}, {0, 1}));
  EXPECT_TRUE(isAllButCertain({finalist(0, -12), finalist(0, -11.9), finalist(9, -10.5)}, {0, 2}));
  EXPECT_FALSE(isAllButCertain({finalist(0, -12), finalist(9, -11.5)}, {0, 1}));
  EXPECT_FALSE(isAllButCertain({finalist(0, -8.7)}, {0}));
}

TEST_F(DistinctFinalists, fourAnswersAndOneThatWasLaidAreRefinedAtMost) {
  std::vector<Finalist> finalists;
  for (int column : {0, 4, 8, 12, 16, 20})
    finalists.push_back(finalist(column, -7 + column / 80.0));
  const Answers all{0, 1, 2, 3, 4, 5};
  EXPECT_EQ(leadingOf(finalists, all), (Answers{0, 1, 2, 3}));
  finalists.back().bent.emplace();
  finalists.back().laid = true;
  EXPECT_EQ(leadingOf(finalists, all), (Answers{0, 1, 2, 3, 5}));
}

}  // namespace
}  // namespace posture
