// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "answer/message.h"
#include "answer/verdict.h"
#include "pipeline/made_up_answers.h"
#include <cmath>

namespace posture {
namespace {

using test::answerWith;
using ::testing::HasSubstr;
using ::testing::StartsWith;

/// With a second answer so much worse.
RegistrationResult twoAnswers(double score, double margin) {
  RegistrationResult result = answerWith(score, 1);
  result.alternatives.push_back(result.alternatives[0]);
  result.alternatives[1].score += margin;
  *result.alternatives[1].refined_score += margin;
  result.alternatives[1].gap = 0.4567;
  setTrust(trustIn(result), result);
  return result;
}

TEST(Message, saysHowMuchHasACounterpart) {
  RegistrationResult result = twoAnswers(-15, 5);
  EXPECT_EQ(messageOf(result), "3 of 3 source vertices have a counterpart (100.0 %)");
  result.correspondence.on_target[1].vertex = -1;
  EXPECT_EQ(messageOf(result), "2 of 3 source vertices have a counterpart (66.6 %)");
  result.source_scan.emplace().summary.missing = 1;
  EXPECT_EQ(messageOf(result), "2 of 2 source points have a counterpart (100.0 %)");
}

TEST(Message, doesNotRoundUpToAllOrToALimit) {
  RegistrationResult result = twoAnswers(-15, 5);
  result.correspondence.on_target.assign(9999, {1, -1, {}});
  result.correspondence.on_target.emplace_back();
  EXPECT_THAT(messageOf(result),
              HasSubstr("9999 of 10000 source vertices have a counterpart (99.9 %)"));
  result = twoAnswers(-5, 5);
  setTrust(0.4999, result);
  EXPECT_THAT(messageOf(result), HasSubstr("trusted to 49.9 % only"));
}

TEST(Message, saysWhichAnswersTheDataDoNotDecideBetween) {
  EXPECT_EQ(
      messageOf(twoAnswers(-15, 0)).substr(0, 89),
      "the data do not decide between answers that lie 45.6 % of the body's size (square root of");
}

TEST(Message, saysThatTheBodiesAreNotAlike) {
  for (const RegistrationResult& result : {twoAnswers(-5, 5), twoAnswers(-5, 0)})
    EXPECT_THAT(messageOf(result), StartsWith("source and target do not look like one body in"));
}

TEST(Message, saysThatHandsAreMirrored) {
  RegistrationResult result = twoAnswers(-5, 5);
  result.hands = 5;  // -10 without
  EXPECT_THAT(messageOf(result), StartsWith("the best map takes hands or feet to the mirror"));
}

TEST(Message, saysThatThereIsNoMap) {
  RegistrationResult result;
  leaveWhereItIs(Points::Zero(3, 3), result);
  EXPECT_THAT(messageOf(result), HasSubstr("tears the surface or turns it inside out"));
}

TEST(Message, saysHowMuchAgreesUnderThePublishedMethod) {
  RegistrationResult result = answerWith(0, 1);
  result.alternatives.clear();
  HypothesisSummary& chosen = result.hypotheses.emplace_back();
  givePublishedVerdict(result);
  EXPECT_THAT(messageOf(result), StartsWith("no candidate gives a consistent map"));
  chosen.accepted_vertices = 3;
  chosen.consistency = 0.5;
  givePublishedVerdict(result);
  EXPECT_THAT(messageOf(result), HasSubstr("agree to only 50.0 % under the best candidate"));
  chosen.consistency = 1;
  givePublishedVerdict(result);
  EXPECT_THAT(messageOf(result), StartsWith("3 of 3 source vertices"));
}

TEST(Message, endsWithWhatIsLeftOutAndAsLargeAsABody) {
  for (const double margin : {0.0, 5.0}) {
    RegistrationResult result = twoAnswers(-15, margin);
    const std::string all = messageOf(result);
    result.source.left_out_share = 0.49;
    EXPECT_EQ(messageOf(result), all);
    result.source.left_out_share = 0.81;
    EXPECT_EQ(
        messageOf(result),
        all + "; another part of the source, 81.0 % as large as the one registered, is left out");
    result.source.left_out_share = 0;
    result.target.background_faces = 7;
    EXPECT_EQ(messageOf(result), all + "; a floor or wall in the target is left out");
  }
}

}  // namespace
}  // namespace posture
