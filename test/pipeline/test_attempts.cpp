// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "attempts.h"
#include <cmath>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

namespace posture {
namespace {

/// All of three vertices taken to one place.
RegistrationResult resultWith(double score, double trust, int place) {
  RegistrationResult result;
  result.chosen = 0;
  result.score = score;
  result.trust = trust;
  result.correspondence.on_target.assign(3, SurfacePoint{place, -1, Eigen::Vector3d::Zero()});
  result.correspondence.confidence = Vector::Constant(3, trust);
  result.deformed = Points::Constant(3, 3, place);
  return result;
}

TEST(Attempts, aMapFoundWithClosedHolesIsTakenWithTheTrustFoundWithout) {
  const RegistrationResult result = withMapOf(resultWith(-12, 0.8, 1), resultWith(-11.5, 0.4, 2));
  EXPECT_EQ(result.correspondence.on_target[0].vertex, 2);
  EXPECT_EQ(result.deformed(0, 0), 2);
  EXPECT_DOUBLE_EQ(result.correspondence.confidence[0], 0.8);
  EXPECT_EQ(result.score, -12);
}

TEST(Attempts, aMapFoundWithClosedHolesIsTrustedAsMuchAsEither) {
  const RegistrationResult result = withMapOf(resultWith(-8.5, 0.3, 1), resultWith(-9.4, 0.8, 2));
  EXPECT_EQ(result.correspondence.on_target[0].vertex, 2);
  EXPECT_DOUBLE_EQ(result.trust, 0.8);
  EXPECT_DOUBLE_EQ(result.correspondence.confidence[0], 0.8);
  EXPECT_EQ(result.score, -9.4);
}

TEST(Attempts, theWayBackIsTrustedAsTheWayThere) {
  RegistrationResult patched = resultWith(-11.5, 0.4, 2);
  patched.back = WayBack{patched.correspondence};
  const RegistrationResult result = withMapOf(resultWith(-12, 0.8, 1), std::move(patched));
  ASSERT_TRUE(result.back);
  EXPECT_DOUBLE_EQ(result.back->correspondence.confidence[0], 0.8);
}

/// One with a single answer.
RegistrationResult answerWith(double score, int place) {
  RegistrationResult result = resultWith(score, 0.9, place);
  result.alternatives.resize(1);
  result.alternatives[0].score = score;
  result.alternatives[0].refined_score = score;
  result.alternatives[0].correspondence = result.correspondence;
  result.target.area = 1;
  return result;
}

RegistrationResult best(std::vector<Attempt> attempts) {
  RegistrationOptions options;
  options.refine_alternatives = true;
  const Observer nobody;
  StageClock clock(nobody);
  const TriangleMesh target{Points::Identity(3, 3), Faces(0, 3)};
  return bestAttempt(
      std::move(attempts), target, options, [](const auto&) { return std::nullopt; }, clock);
}

/// A triangle's corners taken to corners, -1: none.
RegistrationResult mapOf(double score, std::vector<int> corners) {
  RegistrationResult result = answerWith(score, 0);
  for (std::size_t v = 0; v < corners.size(); ++v)
    result.correspondence.on_target[v].vertex = corners[v];
  return result;
}

TEST(Attempts, anAnswerGoesOnWhereItMapsMoreToTheSamePlaces) {
  const TriangleMesh target{Points::Identity(3, 3), Faces(0, 3)};
  const RegistrationResult known = mapOf(-10, {0, -1, -1});
  EXPECT_TRUE(goesOn(known, mapOf(-9, {0, 1, 2}), target));
  EXPECT_FALSE(goesOn(known, mapOf(-9, {1, 0, 2}), target));
  EXPECT_FALSE(goesOn(mapOf(-10, {0, 1, -1}), known, target));
}

TEST(Attempts, whatAgreesWithTheExtendedAnswerIsNoRival) {
  RegistrationOptions options;
  const Observer nobody;
  StageClock clock(nobody);
  const TriangleMesh target{Points::Identity(3, 3), Faces(0, 3)};
  const auto extendedTo = [&](const RegistrationResult& whole) {
    const std::vector<Attempt> attempts{{mapOf(-12, {0, -1, -1}), {}},
                                        {mapOf(-11.5, {-1, 1, 2}), {}}};
    return bestAttempt(
        attempts,
        target,
        options,
        [&](const RegistrationResult& known) {
          const bool is_best = known.correspondence.on_target[0].vertex == 0;
          return is_best ? std::optional(whole) : std::nullopt;
        },
        clock);
  };
  const RegistrationResult alone = extendedTo(mapOf(-12, {0, 1, 2}));
  EXPECT_EQ(mappedCount(alone.correspondence.on_target), 3);
  EXPECT_EQ(alone.alternatives.size(), 1u);
  EXPECT_DOUBLE_EQ(alone.trust, 0.9);
  const RegistrationResult disputed = extendedTo(mapOf(-12, {0, 2, 1}));
  EXPECT_EQ(disputed.alternatives.size(), 2u);
  EXPECT_LT(disputed.trust, 0.9);
}

TEST(Attempts, anAnswerPaysWhereItFitsWorseOverTheWhole) {
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

TEST(Attempts, ofTwoAnswersFoundWithPartsTheOneWinsThatFitsOverTheWhole) {
  RegistrationOptions options;
  const Observer nobody;
  StageClock clock(nobody);
  const TriangleMesh target{Points::Identity(3, 3), Faces(0, 3)};
  const std::vector<Attempt> attempts{{mapOf(-12, {0, 1, 2}), {}}, {mapOf(-11.5, {1, 2, 0}), {}}};
  std::vector<int> asked;
  const RegistrationResult result = bestAttempt(
      attempts,
      target,
      options,
      [&](RegistrationResult known) {
        const int place = known.correspondence.on_target[0].vertex;
        asked.push_back(place);
        payForExtending(place == 0 ? -9.0 : -11.5, 0, known);
        return std::optional(known);
      },
      clock);
  EXPECT_THAT(asked, testing::ElementsAre(0, 1));
  EXPECT_EQ(result.correspondence.on_target[0].vertex, 1);
  EXPECT_EQ(result.score, -11.5);
  ASSERT_EQ(result.alternatives.size(), 2u);
  EXPECT_GT(*result.alternatives[1 - result.chosen].refined_score, -10);
  EXPECT_GT(result.trust, 0.85);
}

TEST(Attempts, anAnswerThatDoesNotGoOnGivesWayToABetterOne) {
  RegistrationOptions options;
  const Observer nobody;
  StageClock clock(nobody);
  const TriangleMesh target{Points::Identity(3, 3), Faces(0, 3)};
  const std::vector<Attempt> attempts{{mapOf(-8.5, {1, 2, 0}), {}}, {mapOf(-9.8, {0, 1, 2}), {}}};
  const RegistrationResult result = bestAttempt(
      attempts,
      target,
      options,
      [](RegistrationResult known) -> std::optional<RegistrationResult> {
        if (known.score > -9) return {};  // found with all there is
        payForExtending(-7.7, 0, known);
        return known;
      },
      clock);
  EXPECT_EQ(result.score, -8.5);
  EXPECT_EQ(result.correspondence.on_target[0].vertex, 1);
  EXPECT_EQ(result.status, Status::UNDECIDED);
}

TEST(Attempts, aRivalCostsAllMapsTrustAndIsLessLikelyItself) {
  const RegistrationResult result = best({{answerWith(-12, 1), {}}, {answerWith(-11.5, 2), {}}});
  ASSERT_EQ(result.alternatives.size(), 2u);
  EXPECT_EQ(result.chosen, 0);
  EXPECT_LT(result.trust, 0.9);
  EXPECT_NEAR(result.correspondence.confidence[0], result.trust, 1e-12);
  EXPECT_NEAR(result.alternatives[0].correspondence.confidence[0], result.trust, 1e-12);
  EXPECT_NEAR(
      result.alternatives[1].correspondence.confidence[0], result.trust * std::exp(-0.5), 1e-12);
}

TEST(Attempts, oneThatMapsLessAndAgreesThereIsNoRival) {
  RegistrationResult part = answerWith(-11.5, 1);
  part.correspondence.on_target[1] = part.correspondence.on_target[2] = {};
  const RegistrationResult result = best({{answerWith(-12, 1), {}}, {part, {}}});
  EXPECT_EQ(result.alternatives.size(), 1u);
  EXPECT_DOUBLE_EQ(result.trust, 0.9);
}

TEST(Attempts, aTieLeavesConfidencesInProportion) {
  const RegistrationResult result = best({{answerWith(-12, 1), {}}, {answerWith(-12, 2), {}}});
  EXPECT_GT(result.trust, 0);
  EXPECT_LT(result.trust, 0.01);
  EXPECT_DOUBLE_EQ(result.correspondence.confidence[0], result.trust);
}

TEST(Attempts, onlyTheBestIsFinished) {
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
  return {answerWith(score, place),
          []() -> RegistrationResult { throw std::runtime_error("no surface"); }};
}

TEST(Attempts, oneThatCannotBeFinishedIsLeft) {
  const Attempt failing = unfinishable(-12, 2);
  const RegistrationResult result = best({{answerWith(-11, 1), {}}, failing});
  EXPECT_EQ(result.score, -11);
  EXPECT_EQ(result.alternatives.size(), 1u);
  EXPECT_EQ(best({failing, {answerWith(-11, 1), {}}}).score, -11);
  EXPECT_THROW(best({failing}), std::runtime_error);
}

TEST(Attempts, aRivalThatCannotBeFinishedIsStillNamed) {
  const RegistrationResult result = best({{answerWith(-12, 1), {}}, unfinishable(-11, 2)});
  EXPECT_EQ(result.score, -12);
  ASSERT_EQ(result.alternatives.size(), 2u);
  EXPECT_EQ(result.alternatives[1].score, -11);
}

TEST(Attempts, areChangedBeforeAndAfterTheyAreFinished) {
  const Attempt attempt = withChange({answerWith(-12, 1), [] { return answerWith(-12, 2); }},
                                     [](RegistrationResult& result) { ++result.source.samples; });
  EXPECT_EQ(attempt.found.source.samples, 1);
  EXPECT_EQ(finished(attempt).source.samples, 1);
  EXPECT_EQ(finished(attempt).correspondence.on_target[0].vertex, 2);
}

TEST(Attempts, aMapThatClosedHolesLedAstrayScoresFarWorse) {
  const RegistrationResult without = answerWith(-12, 1);
  EXPECT_TRUE(leadsAstray(without, answerWith(-10.5, 1)));
  EXPECT_FALSE(leadsAstray(without, answerWith(-11.5, 1)));
  RegistrationResult hands_seen = answerWith(-11.5, 1);
  payForHands(3, hands_seen);
  EXPECT_FALSE(leadsAstray(without, hands_seen));
}

TEST(Attempts, handsOnTheOtherSideArePaidForOnce) {
  RegistrationResult result = answerWith(-12, 1);
  const double trust = result.trust;
  payForHands(5, result);
  payForHands(5, result);
  payForHands(2, result);
  EXPECT_EQ(result.hands, 5);
  EXPECT_EQ(result.score, -7);
  EXPECT_LT(result.trust, 0.1 * trust);
  EXPECT_EQ(result.status, Status::UNDECIDED);
  EXPECT_THAT(result.message, testing::HasSubstr("mirror images"));
}

TEST(Attempts, whatOneKnowsOfTheHandsHoldsForAllOfOneAnswer) {
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

TEST(Attempts, anAnswerThatIsAllButCertainAndNotAstrayStands) {
  RegistrationResult known = answerWith(-12, 1);  // trusted to 0.9
  const double score = known.alternatives[known.chosen].score;
  EXPECT_TRUE(knownStands(known, score));
  EXPECT_TRUE(knownStands(known, score - 0.5));
  EXPECT_FALSE(knownStands(known, score - 1.5));
  known.trust = 0.8;
  EXPECT_FALSE(knownStands(known, score));
}

TEST(Attempts, anAnswerIsTheSameOnlyWhereBothMapHalfOfWhatEitherDoes) {
  const TriangleMesh target{Points::Identity(3, 3), Faces(0, 3)};
  const RegistrationResult whole = answerWith(-12, 1);
  RegistrationResult most = whole, third = whole;
  most.correspondence.on_target[0] = {};
  third.correspondence.on_target[0] = third.correspondence.on_target[1] = {};
  EXPECT_TRUE(isSameAnswer(whole, most, target));
  EXPECT_FALSE(isSameAnswer(whole, third, target));
  EXPECT_FALSE(isSameAnswer(whole, answerWith(-12, 2), target));
}

TEST(Attempts, mapsThatDifferInAHandDoNotAgreeEverywhere) {
  const TriangleMesh line{Points::NullaryExpr(100, 3, [](auto row, auto) { return 0.01 * row; }),
                          Faces(0, 3)};
  std::vector<SurfacePoint> own(100), other(100);
  for (int v = 0; v < 100; ++v) own[v].vertex = other[v].vertex = v;
  other[3].vertex = 40;
  own[50].vertex = -1;
  EXPECT_TRUE(agreeEverywhere(own, other, line, 1));
  EXPECT_TRUE(agreeEverywhere(other, own, line, 1));
  other[4].vertex = 41;
  EXPECT_FALSE(agreeEverywhere(own, other, line, 1));
  EXPECT_TRUE(agreeEverywhere(own, other, line, 10));
  for (int v = 0; v < 51; ++v) own[v].vertex = -1;
  EXPECT_FALSE(agreeEverywhere(own, other, line, 10));  // they share too little
  own.assign(100, {});
  EXPECT_FALSE(agreeEverywhere(own, other, line, 10));
}

}  // namespace
}  // namespace posture
