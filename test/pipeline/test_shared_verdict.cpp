// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "answer/shared_verdict.h"
#include "pipeline/made_up_answers.h"
#include <utility>

namespace posture {
namespace {

using test::answerWith;
using test::resultWith;

TEST(SharedVerdict, aMapFoundWithClosedHolesIsTakenWithTheTrustFoundWithout) {
  const RegistrationResult result = withMapOf(resultWith(-12, 0.8, 1), resultWith(-11.5, 0.4, 2));
  EXPECT_EQ(result.correspondence.on_target[0].vertex, 2);
  EXPECT_EQ(result.deformed(0, 0), 2);
  EXPECT_DOUBLE_EQ(result.correspondence.confidence[0], 0.8);
  EXPECT_EQ(result.score, -12);
}

TEST(SharedVerdict, aMapFoundWithClosedHolesIsTrustedAsMuchAsEither) {
  const RegistrationResult result = withMapOf(resultWith(-8.5, 0.3, 1), resultWith(-9.4, 0.8, 2));
  EXPECT_EQ(result.correspondence.on_target[0].vertex, 2);
  EXPECT_DOUBLE_EQ(result.trust, 0.8);
  EXPECT_DOUBLE_EQ(result.correspondence.confidence[0], 0.8);
  EXPECT_EQ(result.score, -9.4);
}

TEST(SharedVerdict, theWayBackIsTrustedAsTheWayThere) {
  RegistrationResult patched = resultWith(-11.5, 0.4, 2);
  patched.back = WayBack{patched.correspondence};
  const RegistrationResult result = withMapOf(resultWith(-12, 0.8, 1), std::move(patched));
  ASSERT_TRUE(result.back);
  EXPECT_DOUBLE_EQ(result.back->correspondence.confidence[0], 0.8);
}

TEST(SharedVerdict, anAnswerPaysWhereItFitsWorseOverTheWhole) {
  RegistrationResult result = answerWith(-12, 1);
  result.trust = 1;
  payForExtending(-12, 0, result);  // limbs bend that were not in the part
  EXPECT_EQ(result.score, -12);
  EXPECT_EQ(result.trust, 1);
  payForExtending(-7, 0, result);
  EXPECT_EQ(result.score, -7);
  EXPECT_DOUBLE_EQ(*result.alternatives[0].refined_score, result.score);
  EXPECT_LT(result.trust, 0.5);
  EXPECT_EQ(result.status, Status::UNDECIDED);
}

TEST(SharedVerdict, aMapThatClosedHolesLedAstrayScoresFarWorse) {
  const RegistrationResult without = answerWith(-12, 1);
  EXPECT_TRUE(leadsAstray(without, answerWith(-10.5, 1)));
  EXPECT_FALSE(leadsAstray(without, answerWith(-11.5, 1)));
  RegistrationResult hands_seen = answerWith(-11.5, 1);
  payForHands(3, hands_seen);
  EXPECT_FALSE(leadsAstray(without, hands_seen));
}

TEST(SharedVerdict, handsOnTheOtherSideArePaidForOnce) {
  RegistrationResult result = answerWith(-12, 1);
  const double trust = result.trust;
  payForHands(5, result);
  payForHands(5, result);
  payForHands(2, result);
  EXPECT_EQ(result.hands, 5);
  EXPECT_EQ(result.score, -7);
  EXPECT_LT(result.trust, 0.1 * trust);
  EXPECT_EQ(result.status, Status::UNDECIDED);
}

TEST(SharedVerdict, anAnswerThatIsAllButCertainAndNotAstrayStands) {
  RegistrationResult known = answerWith(-12, 1);  // trusted to 0.9
  const double score = known.alternatives[known.chosen].score;
  EXPECT_TRUE(knownStands(known, score));
  EXPECT_TRUE(knownStands(known, score - 0.5));
  EXPECT_FALSE(knownStands(known, score - 1.5));
  known.trust = 0.8;
  EXPECT_FALSE(knownStands(known, score));
}

}  // namespace
}  // namespace posture
