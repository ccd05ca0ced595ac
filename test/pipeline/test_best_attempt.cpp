// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "answer/attempt.h"
#include "answer/shared_verdict.h"
#include "attempts/best_attempt.h"
#include "no_way_on.h"
#include "pipeline/made_up_answers.h"
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace posture {
namespace {

using test::answerWith;
using test::mapOf;

RegistrationResult best(std::vector<Attempt> attempts,
                        const Extension& extended,
                        bool refine_alternatives = false) {
  RegistrationOptions options;
  options.refine_alternatives = refine_alternatives;
  const Observer nobody;
  StageClock clock(nobody);
  const TriangleMesh target{Points::Identity(3, 3), Faces(0, 3)};
  return bestAttempt(std::move(attempts), target, options, extended, clock);
}

RegistrationResult best(std::vector<Attempt> attempts) {
  return best(
      std::move(attempts), [](const auto&) { return std::nullopt; }, true);
}

TEST(BestAttempt, whatAgreesWithTheExtendedAnswerIsNoRival) {
  const auto extendedTo = [&](const RegistrationResult& whole) {
    const std::vector<Attempt> attempts{{mapOf(-12, {0, -1, -1}), {}},
                                        {mapOf(-11.5, {-1, 1, 2}), {}}};
    return best(attempts, [&](const RegistrationResult& known) {
      const bool is_best = known.correspondence.on_target[0].vertex == 0;
      return is_best ? std::optional(whole) : std::nullopt;
    });
  };
  const RegistrationResult alone = extendedTo(mapOf(-12, {0, 1, 2}));
  EXPECT_EQ(mappedCount(alone.correspondence.on_target), 3);
  EXPECT_EQ(alone.alternatives.size(), 1u);
  EXPECT_DOUBLE_EQ(alone.trust, 0.9);
  const RegistrationResult disputed = extendedTo(mapOf(-12, {0, 2, 1}));
  EXPECT_EQ(disputed.alternatives.size(), 2u);
  EXPECT_LT(disputed.trust, 0.9);
}

TEST(BestAttempt, ofTwoAnswersFoundWithPartsTheOneWinsThatFitsOverTheWhole) {
  const std::vector<Attempt> attempts{{mapOf(-12, {0, 1, 2}), {}}, {mapOf(-11.5, {1, 2, 0}), {}}};
  std::vector<int> asked;
  const RegistrationResult result = best(attempts, [&](RegistrationResult known) {
    const int place = known.correspondence.on_target[0].vertex;
    asked.push_back(place);
    payForExtending(place == 0 ? -9.0 : -11.5, 0, known);
    return std::optional(known);
  });
  EXPECT_THAT(asked, testing::ElementsAre(0, 1));
  EXPECT_EQ(result.correspondence.on_target[0].vertex, 1);
  EXPECT_EQ(result.score, -11.5);
  ASSERT_EQ(result.alternatives.size(), 2u);
  EXPECT_GT(*result.alternatives[1 - result.chosen].refined_score, -10);
  EXPECT_GT(result.trust, 0.85);
}

TEST(BestAttempt, anAnswerThatDoesNotGoOnGivesWayToABetterOne) {
  const std::vector<Attempt> attempts{{mapOf(-8.5, {1, 2, 0}), {}}, {mapOf(-9.8, {0, 1, 2}), {}}};
  const RegistrationResult result =
      best(attempts, [](RegistrationResult known) -> std::optional<RegistrationResult> {
        if (known.score > -9) return {};  // found with all there is
        payForExtending(-7.7, 0, known);
        return known;
      });
  EXPECT_EQ(result.score, -8.5);
  EXPECT_EQ(result.correspondence.on_target[0].vertex, 1);
  EXPECT_EQ(result.status, Status::UNDECIDED);
}

TEST(BestAttempt, anAnswerThatDoesNotGoOnLeavesTheSameOneFoundWithAllThereIs) {
  RegistrationResult part = mapOf(-12, {0, 1, 2});
  part.source.compared_share = 0.5;
  const RegistrationResult result =
      best({{mapOf(-11, {0, 1, 2}), {}}, {part, {}}},
           [](RegistrationResult known) -> std::optional<RegistrationResult> {
             if (known.source.compared_share == 1) return {};
             payForExtending(-7.7, 0, known);
             return known;
           });
  EXPECT_EQ(result.score, -11);
  EXPECT_EQ(result.alternatives.size(), 1u) << "the other one agrees";
  EXPECT_DOUBLE_EQ(result.trust, 0.9);
}

TEST(BestAttempt, ofPartsWithOneAnswerTheOneThatWasExtendedStandsForAll) {
  const auto part = [](double score) {
    RegistrationResult result = mapOf(score, {1, 2, 0});
    result.source.compared_share = 0.5;
    return Attempt{result, {}};
  };
  int extensions = 0;
  const RegistrationResult result =
      best({{mapOf(-10, {0, 1, 2}), {}}, part(-12), part(-11.9)},
           [&](RegistrationResult known) -> std::optional<RegistrationResult> {
             if (!isOfPart(known)) return {};
             ++extensions;
             payForExtending(-9, 0, known);
             return known;
           });
  EXPECT_EQ(extensions, 1);
  EXPECT_EQ(result.score, -10);
  EXPECT_EQ(result.status, Status::REGISTERED);
  ASSERT_EQ(result.alternatives.size(), 2u);
  EXPECT_EQ(*result.alternatives[1 - result.chosen].refined_score, -9);
}

TEST(BestAttempt, whereARivalComesToAgreeTheNextOneCounts) {
  int extensions = 0;
  const RegistrationResult result = best(
      {{mapOf(-12, {0, 1, 2}), {}}, {mapOf(-11.9, {1, 2, 0}), {}}, {mapOf(-10.9, {2, 0, 1}), {}}},
      [&](const RegistrationResult& known) -> std::optional<RegistrationResult> {
        ++extensions;
        return mapOf(known.score, {0, 1, 2});
      });
  EXPECT_EQ(extensions, 2) << "the third is decisively worse";
  EXPECT_EQ(result.score, -12);
  ASSERT_EQ(result.alternatives.size(), 2u);
  EXPECT_EQ(result.alternatives[1].score, -10.9);
  EXPECT_LT(result.trust, 0.9);
}

TEST(BestAttempt, aRivalCostsAllMapsTrustAndIsLessLikelyItself) {
  const RegistrationResult result = best({{answerWith(-12, 1), {}}, {answerWith(-11.5, 2), {}}});
  ASSERT_EQ(result.alternatives.size(), 2u);
  EXPECT_EQ(result.chosen, 0);
  EXPECT_LT(result.trust, 0.9);
  EXPECT_NEAR(result.correspondence.confidence[0], result.trust, 1e-12);
  EXPECT_NEAR(result.alternatives[0].correspondence.confidence[0], result.trust, 1e-12);
  EXPECT_NEAR(
      result.alternatives[1].correspondence.confidence[0], result.trust * std::exp(-0.5), 1e-12);
}

TEST(BestAttempt, whatEndsCostWithinAnAttemptIsNothingToAnother) {
  RegistrationResult paid = answerWith(-12.5, 1), other_paid = answerWith(-11.9, 2);
  paid.alternatives[0].refined_score = -11.8;
  other_paid.alternatives[0].refined_score = -10;
  const double trust = best({{answerWith(-12.5, 1), {}}, {answerWith(-11.9, 2), {}}}).trust;
  EXPECT_GT(trust, 0.5);
  EXPECT_NEAR(best({{paid, {}}, {answerWith(-11.9, 2), {}}}).trust, trust, 1e-12);
  EXPECT_NEAR(best({{answerWith(-12.5, 1), {}}, {other_paid, {}}}).trust, trust, 1e-12);
}

TEST(BestAttempt, oneThatMapsLessAndAgreesThereIsNoRival) {
  RegistrationResult part = answerWith(-11.5, 1);
  part.correspondence.on_target[1] = part.correspondence.on_target[2] = {};
  const RegistrationResult result = best({{answerWith(-12, 1), {}}, {part, {}}});
  EXPECT_EQ(result.alternatives.size(), 1u);
  EXPECT_DOUBLE_EQ(result.trust, 0.9);
}

TEST(BestAttempt, aTieLeavesConfidencesInProportion) {
  const RegistrationResult result = best({{answerWith(-12, 1), {}}, {answerWith(-12, 2), {}}});
  EXPECT_GT(result.trust, 0);
  EXPECT_LT(result.trust, 0.01);
  EXPECT_DOUBLE_EQ(result.correspondence.confidence[0], result.trust);
}

TEST(BestAttempt, onlyTheBestIsFinished) {
  const auto attempt = [](double score, int place, int& finishings) {
    return Attempt{answerWith(score, place), [=, &finishings] {
                     ++finishings;
                     return answerWith(score, place);
                   }};
  };
  int worse = 0, better = 0;
  EXPECT_EQ(best({attempt(-11, 1, worse), attempt(-12, 1, better)}).score, -12);
  EXPECT_EQ(worse, 0);
  EXPECT_EQ(better, 1);
}

Attempt unfinishable(double score, int place) {
  return {answerWith(score, place), []() -> RegistrationResult { throw NoWayOn("no surface"); }};
}

TEST(BestAttempt, oneThatCannotBeFinishedIsLeft) {
  const Attempt failing = unfinishable(-12, 2);
  const RegistrationResult result = best({{answerWith(-11, 1), {}}, failing});
  EXPECT_EQ(result.score, -11);
  EXPECT_EQ(result.alternatives.size(), 1u);
  EXPECT_EQ(best({failing, {answerWith(-11, 1), {}}}).score, -11);
  EXPECT_THROW(best({failing}), NoWayOn);
}

TEST(BestAttempt, aRivalThatCannotBeFinishedIsStillNamed) {
  const RegistrationResult result = best({{answerWith(-12, 1), {}}, unfinishable(-11, 2)});
  EXPECT_EQ(result.score, -12);
  ASSERT_EQ(result.alternatives.size(), 2u);
  EXPECT_EQ(result.alternatives[1].score, -11);
}

TEST(BestAttempt, whatOneKnowsOfTheHandsHoldsForAllOfOneAnswer) {
  RegistrationResult seen = answerWith(-12, 1);
  payForHands(5, seen);
  // The same answer by a part that has no hands, and the right one.
  const auto part = [] { return answerWith(-11.5, 1); };
  const RegistrationResult result = best({{seen, {}}, {part(), part}, {answerWith(-9, 2), {}}});
  EXPECT_EQ(result.correspondence.on_target[0].vertex, 2);
  const RegistrationResult turned = best({{seen, {}}, {part(), part}});
  EXPECT_GE(turned.hands, 5);
  EXPECT_EQ(turned.status, Status::UNDECIDED);
}

}  // namespace
}  // namespace posture
