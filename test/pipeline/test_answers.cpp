// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "answers.h"
#include "support/shapes.h"
#include "verdict.h"
#include <cmath>
#include <limits>
#include <vector>

namespace posture {
namespace {

using Answers = std::vector<int>;

/// A strip of 21 columns, 0.05 apart.
class AnswersTest : public testing::Test {
 protected:
  const TriangleMesh strip_ = test::grid(20, 1, 1, 0.05);

  /// All of it to one column.
  VertexMaps mapTo(int column) const {
    VertexMaps maps;
    maps.forward.assign(strip_.vertices.rows(), column);
    return maps;
  }

  Finalist finalist(int column, double score = 0) const {
    Finalist f;
    f.maps = mapTo(column);
    f.score = scoring(score);
    return f;
  }

  static MapScore scoring(double total) {
    MapScore score;
    score.bending = score.curvature = score.distortion = score.return_miss = std::exp(total / 4);
    return score;
  }

  RefinedMap refined(int finalist, int column, double score) const {
    RefinedMap map;
    map.finalist = finalist;
    map.pair.maps = mapTo(column);
    map.score = scoring(score);
    return map;
  }
};

TEST_F(AnswersTest, finalistsThatLeadToNearlyTheSamePlaceAreOne) {
  std::vector<Finalist> finalists;
  for (int column : {0, 4, 5, 8, 12, 16, 17, 20}) finalists.push_back(finalist(column));
  EXPECT_EQ(distinctFinalists(finalists, strip_, 0.07), (Answers{0, 1, 3, 4, 5, 7}));
}

TEST_F(AnswersTest, theOneThatWinsIsAmongTheForemost) {
  const Answers distinct{0, 1, 3, 4, 5, 7};
  EXPECT_EQ(foremost(distinct, 1, 4), (Answers{0, 1, 3, 4}));
  EXPECT_EQ(foremost(distinct, 4, 4), (Answers{0, 1, 3, 4}));
  EXPECT_EQ(foremost(distinct, 7, 4), (Answers{0, 1, 3, 7}));
  EXPECT_EQ(foremost(distinct, 7, 9), distinct);
}

TEST_F(AnswersTest, anotherAnswerIsRefinedWhereScoresDoNotDecide) {
  const std::vector<Finalist> near{finalist(0, -12), finalist(0, -11.9), finalist(9, -11.5)};
  EXPECT_EQ(leadingOf(near, {0, 2}), (Answers{0, 2}));
  const std::vector<Finalist> far{finalist(0, -12), finalist(0, -11.9), finalist(9, -10.5)};
  EXPECT_EQ(leadingOf(far, {0, 2}), (Answers{0}));
  EXPECT_EQ(leadingOf({finalist(0, -12)}, {0}), (Answers{0}));
}

TEST_F(AnswersTest, anAnswerIsAllButCertainWhereItFitsAndNoOtherComesNear) {
  EXPECT_TRUE(isAllButCertain({finalist(0, -12)}, {0}));
  EXPECT_TRUE(isAllButCertain({finalist(0, -12), finalist(9, -10.5)}, {0, 1}));
  EXPECT_TRUE(isAllButCertain({finalist(0, -12), finalist(0, -11.9), finalist(9, -10.5)}, {0, 2}));
  EXPECT_FALSE(isAllButCertain({finalist(0, -12), finalist(9, -11.5)}, {0, 1}));
  EXPECT_FALSE(isAllButCertain({finalist(0, -8.7)}, {0}));
}

TEST_F(AnswersTest, fourAnswersAndOneThatWasLaidAreRefinedAtMost) {
  std::vector<Finalist> finalists;
  for (int column : {0, 4, 8, 12, 16, 20})
    finalists.push_back(finalist(column, -7 + column / 80.0));
  const Answers all{0, 1, 2, 3, 4, 5};
  EXPECT_EQ(leadingOf(finalists, all), (Answers{0, 1, 2, 3}));
  finalists.back().bent.emplace();
  finalists.back().laid = true;
  EXPECT_EQ(leadingOf(finalists, all), (Answers{0, 1, 2, 3, 5}));
}

TEST_F(AnswersTest, whatRefinementLeadsToTheBestIsNoAnswerOfItsOwn) {
  const std::vector<Finalist> finalists{
      finalist(0, -9), finalist(8, -8.9), finalist(16, -8.8), finalist(20, -8)};
  // The third one wins. One way from the second leads there too, the other does not; the first does
  // in both.
  const std::vector<RefinedMap> maps{refined(2, 16, -11),
                                     refined(1, 15, -10.9),
                                     refined(1, 8, -10.8),
                                     refined(0, 17, -10),
                                     refined(0, 16, -9.9)};
  const RefinedAnswers answers(maps, finalists, {0, 1, 2, 3}, strip_, strip_, 0.07);
  // Those two are one, known by the one that was better before.
  EXPECT_EQ(answers.chosen(), 0);
  EXPECT_EQ(answers.remaining(), (Answers{0, 1, 3}));
  EXPECT_EQ(answers.of(0), &maps[0]);
  EXPECT_EQ(answers.of(1), &maps[2]);
  EXPECT_EQ(answers.of(3), nullptr);
}

TEST_F(AnswersTest, anAnswerThatWasBetterBeforeAndLedElsewhereTooIsNotTheChosenOne) {
  const std::vector<Finalist> finalists{finalist(8, -9), finalist(16, -8.8)};
  const std::vector<RefinedMap> maps{
      refined(1, 16, -11), refined(0, 15, -10.9), refined(0, 8, -10.8)};
  const RefinedAnswers answers(maps, finalists, {0, 1}, strip_, strip_, 0.07);
  EXPECT_EQ(answers.chosen(), 1);
  EXPECT_EQ(answers.remaining(), (Answers{0, 1}));
}

TEST_F(AnswersTest, aMapThatBeganBetweenTwoAnswersCountsForTheNearerOne) {
  const std::vector<Finalist> finalists{finalist(0), finalist(1), finalist(2)};
  const Answers distinct = distinctFinalists(finalists, strip_, 0.07);
  ASSERT_EQ(distinct, (Answers{0, 2}));
  const std::vector<RefinedMap> maps{refined(1, 0, -11), refined(2, 9, -10), refined(0, 0, -9)};
  const RefinedAnswers answers(maps, finalists, distinct, strip_, strip_, 0.07);
  EXPECT_EQ(answers.remaining(), distinct);
  EXPECT_EQ(answers.of(0), &maps[0]);
  EXPECT_EQ(answers.of(2), &maps[1]);
}

TEST_F(AnswersTest, whereMapsEndIsToldOnTheirOwnMesh) {
  const TriangleMesh fine = test::grid(40, 1, 1, 0.025);
  const auto on_fine = [&](int finalist, int column, double score) {
    RefinedMap map = refined(finalist, column, score);
    map.pair.maps.forward.assign(fine.vertices.rows(), column);
    return map;
  };
  const std::vector<Finalist> finalists{finalist(0), finalist(5)};
  const std::vector<RefinedMap> maps{on_fine(0, 0, -11), on_fine(1, 2, -10)};
  EXPECT_EQ(RefinedAnswers(maps, finalists, {0, 1}, strip_, fine, 0.07).remaining(), (Answers{0}));
}

TEST(IsDecisive, onlyFarWorseScoresAre) {
  constexpr double NONE = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(isDecisive(-9, -8));
  EXPECT_FALSE(isDecisive(-9, -8.01));
  EXPECT_FALSE(isDecisive(-8, -9));
  EXPECT_TRUE(isDecisive(-9, NONE));
  EXPECT_FALSE(isDecisive(NONE, -9));
  EXPECT_FALSE(isDecisive(NONE, NONE)) << "neither has a map";
}

TEST(MayConvince, whatConvincesMayAndWhatIsDecisivelyWorseMayNot) {
  double limit = -20;
  while (convinces(limit)) limit += 0.01;
  EXPECT_TRUE(mayConvince(limit));
  EXPECT_TRUE(mayConvince(limit - 5));
  EXPECT_FALSE(mayConvince(limit + 1.02));
  EXPECT_FALSE(mayConvince(std::numeric_limits<double>::infinity()));
}

}  // namespace
}  // namespace posture
