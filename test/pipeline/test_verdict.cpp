// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "answer/verdict.h"
#include "pipeline/made_up_answers.h"
#include <cmath>
#include <limits>

namespace posture {
namespace {

using test::answerWith;

TEST(Trust, isOfTheScoreAndOfTheMargin) {
  constexpr double FAR = std::numeric_limits<double>::infinity();
  EXPECT_NEAR(trustIn(EVEN_SCORE, FAR), 0.5, 1e-12) << "same and different bodies are as likely";
  EXPECT_LT(trustIn(EVEN_SCORE + 1, FAR), 0.05);
  EXPECT_GT(trustIn(EVEN_SCORE - 1, FAR), 0.95);
  EXPECT_GT(trustIn(-15, 0), 0) << "confidences are multiples of it";
  EXPECT_LT(trustIn(-15, 0), 1e-5);
  for (double margin = 0.1; margin < 3; margin += 0.1)
    EXPECT_LT(trustIn(-15, margin), trustIn(-15, margin + 0.1));
}

TEST(Trust, isThatBesideTheMostLikelyOtherAnswer) {
  RegistrationResult result = answerWith(-15, 1);
  EXPECT_EQ(rivalOf(result), -1);
  EXPECT_EQ(trustIn(result), trustIn(-15, std::numeric_limits<double>::infinity()));
  result.alternatives.push_back({});
  result.alternatives[1].score = -15 + 0.5;  // of a coarse map, as all `score`
  EXPECT_EQ(trustIn(result), trustIn(-15, 0.5));
  result.alternatives.push_back({});
  result.alternatives[2].score = -14.9;
  result.alternatives[2].refined_score = -14;  // which tells more
  EXPECT_EQ(rivalOf(result), 1);
  EXPECT_EQ(trustIn(result), trustIn(-15, 0.5));
  EXPECT_NEAR(likelihoodOf(result, result.alternatives[2]), std::exp(-1), 1e-12);
  EXPECT_EQ(likelihoodOf(result, result.alternatives[0]), 1);
}

TEST(SetTrust, takesConfidencesAndStatusWithIt) {
  RegistrationResult result = answerWith(-15, 1);  // trusted to 0.9
  result.back.emplace().correspondence = result.correspondence;
  setTrust(0.3, result);
  EXPECT_EQ(result.status, Status::UNDECIDED);
  for (const Correspondence* map : {&result.correspondence,
                                    &result.back->correspondence,
                                    &result.alternatives[0].correspondence})
    EXPECT_NEAR(map->confidence[1], 0.3, 1e-12);
  setTrust(0.5, result);
  EXPECT_EQ(result.status, Status::REGISTERED);
  EXPECT_NEAR(result.correspondence.confidence[1], 0.5, 1e-12);
}

TEST(AddRival, costsTrustByItsMarginAndKeepsTheOrder) {
  RegistrationResult result = answerWith(-15, 1);
  AlternativeSummary rival = result.alternatives[0];
  rival.score = -15.5;  // the better one before refinement
  rival.refined_score = -14.8;
  addRival(rival, 0.9, result);
  ASSERT_EQ(result.alternatives.size(), 2U);
  EXPECT_EQ(result.chosen, 1);
  EXPECT_EQ(result.alternatives[0].score, -15.5);
  EXPECT_NEAR(result.trust, trustIn(-15, 0.2), 1e-12);
  EXPECT_EQ(result.status, Status::UNDECIDED);
  EXPECT_NEAR(result.correspondence.confidence[0], result.trust, 1e-12);
  EXPECT_NEAR(
      result.alternatives[0].correspondence.confidence[0], result.trust * std::exp(-0.2), 1e-12)
      << "by how much less likely it is";
}

TEST(AddRival, givesNoTrust) {
  RegistrationResult result = answerWith(-15, 1);
  setTrust(0.6, result);
  AlternativeSummary rival = result.alternatives[0];
  rival.score = rival.refined_score.emplace(-5);
  addRival(rival, 0.9, result);
  EXPECT_EQ(result.trust, 0.6);
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
