// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "answer/same_answer.h"
#include "pipeline/made_up_answers.h"
#include <vector>

namespace posture {
namespace {

using test::answerWith;
using test::mapOf;

TEST(SameAnswer, anAnswerGoesOnWhereItMapsMoreToTheSamePlaces) {
  const TriangleMesh target{Points::Identity(3, 3), Faces(0, 3)};
  const RegistrationResult known = mapOf(-10, {0, -1, -1});
  EXPECT_TRUE(goesOn(known, mapOf(-9, {0, 1, 2}), target));
  EXPECT_FALSE(goesOn(known, mapOf(-9, {1, 0, 2}), target));
  EXPECT_FALSE(goesOn(mapOf(-10, {0, 1, -1}), known, target));
}

TEST(SameAnswer, anAnswerIsTheSameOnlyWhereBothMapHalfOfWhatEitherDoes) {
  const TriangleMesh target{Points::Identity(3, 3), Faces(0, 3)};
  const RegistrationResult whole = answerWith(-12, 1);
  RegistrationResult most = whole, third = whole;
  most.correspondence.on_target[0] = {};
  third.correspondence.on_target[0] = third.correspondence.on_target[1] = {};
  EXPECT_TRUE(isSameAnswer(whole, most, target));
  EXPECT_FALSE(isSameAnswer(whole, third, target));
  EXPECT_FALSE(isSameAnswer(whole, answerWith(-12, 2), target));
}

TEST(SameAnswer, mapsThatDifferInAHandDoNotAgreeEverywhere) {
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
