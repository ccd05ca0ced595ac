// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "pipeline/strip.h"
#include "refined/finalists/distinct_finalists.h"
#include "refined/refinement/refined_answers.h"
#include "support/shapes.h"
#include <vector>

namespace posture {
namespace {

using Answers = std::vector<int>;

class RefinedAnswersTest : public test::StripTest {};

TEST_F(RefinedAnswersTest, whatRefinementLeadsToTheBestIsNoAnswerOfItsOwn) {
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

TEST_F(RefinedAnswersTest, anAnswerThatWasBetterBeforeAndLedElsewhereTooIsNotTheChosenOne) {
  const std::vector<Finalist> finalists{finalist(8, -9), finalist(16, -8.8)};
  const std::vector<RefinedMap> maps{
      refined(1, 16, -11), refined(0, 15, -10.9), refined(0, 8, -10.8)};
  const RefinedAnswers answers(maps, finalists, {0, 1}, strip_, strip_, 0.07);
  EXPECT_EQ(answers.chosen(), 1);
  EXPECT_EQ(answers.remaining(), (Answers{0, 1}));
}

TEST_F(RefinedAnswersTest, aMapThatBeganBetweenTwoAnswersCountsForTheNearerOne) {
  const std::vector<Finalist> finalists{finalist(0), finalist(1), finalist(2)};
  const Answers distinct = distinctFinalists(finalists, strip_, 0.07);
  ASSERT_EQ(distinct, (Answers{0, 2}));
  const std::vector<RefinedMap> maps{refined(1, 0, -11), refined(2, 9, -10), refined(0, 0, -9)};
  const RefinedAnswers answers(maps, finalists, distinct, strip_, strip_, 0.07);
  EXPECT_EQ(answers.remaining(), distinct);
  EXPECT_EQ(answers.of(0), &maps[0]);
  EXPECT_EQ(answers.of(2), &maps[1]);
}

TEST_F(RefinedAnswersTest, whereWhatWasLetGoOfEndsTellsNothing) {
  const std::vector<Finalist> finalists{finalist(0), finalist(5)};
  std::vector<RefinedMap> maps{refined(0, 0, -11), refined(1, 0, -10)};
  // A third of the second one is elsewhere.
  const std::size_t third = strip_.vertices.rows() / 3;
  for (std::size_t v = 0; v < third; ++v) maps[1].pair.maps.forward[v] = 20;
  const auto remaining = [&] {
    return RefinedAnswers(maps, finalists, {0, 1}, strip_, strip_, 0.07).remaining();
  };
  EXPECT_EQ(remaining(), (Answers{0, 1}));
  maps[1].pair.apart_a.assign(strip_.vertices.rows(), 0);
  for (std::size_t v = 0; v < third; ++v) maps[1].pair.apart_a[v] = 1;
  EXPECT_EQ(remaining(), (Answers{0}));
}

TEST_F(RefinedAnswersTest, whereMapsEndIsToldOnTheirOwnMesh) {
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

}  // namespace
}  // namespace posture
