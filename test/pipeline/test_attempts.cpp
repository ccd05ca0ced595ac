// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "attempts.h"
#include <cmath>
#include <utility>

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
  const RegistrationResult result =
      withPatchedMap(resultWith(-12, 0.8, 1), resultWith(-11.5, 0.4, 2));
  EXPECT_EQ(result.correspondence.on_target[0].vertex, 2);
  EXPECT_EQ(result.deformed(0, 0), 2);
  EXPECT_DOUBLE_EQ(result.correspondence.confidence[0], 0.8);
  EXPECT_EQ(result.score, -12);
}

TEST(Attempts, aMapFoundWithClosedHolesIsTrustedAsMuchAsEither) {
  const RegistrationResult result =
      withPatchedMap(resultWith(-8.5, 0.3, 1), resultWith(-9.4, 0.8, 2));
  EXPECT_EQ(result.correspondence.on_target[0].vertex, 2);
  EXPECT_DOUBLE_EQ(result.trust, 0.8);
  EXPECT_DOUBLE_EQ(result.correspondence.confidence[0], 0.8);
  EXPECT_EQ(result.score, -9.4);
}

TEST(Attempts, theWayBackIsTrustedAsTheWayThere) {
  RegistrationResult patched = resultWith(-11.5, 0.4, 2);
  patched.back = WayBack{patched.correspondence};
  const RegistrationResult result = withPatchedMap(resultWith(-12, 0.8, 1), std::move(patched));
  ASSERT_TRUE(result.back);
  EXPECT_DOUBLE_EQ(result.back->correspondence.confidence[0], 0.8);
}

TEST(Attempts, aRivalCostsAllMapsTrustAndIsLessLikelyItself) {
  const auto attempt = [](double score, int place) {
    RegistrationResult result = resultWith(score, 0.9, place);
    result.alternatives.resize(1);
    result.alternatives[0].score = score;
    result.alternatives[0].refined_score = score;
    result.alternatives[0].correspondence = result.correspondence;
    result.target.area = 1;
    return result;
  };
  RegistrationOptions options;
  options.refine_alternatives = true;
  const TriangleMesh target{Points::Identity(3, 3), Faces(0, 3)};
  const RegistrationResult result =
      bestAttempt({attempt(-12, 1), attempt(-11.5, 2)}, target, options);
  ASSERT_EQ(result.alternatives.size(), 2u);
  EXPECT_EQ(result.chosen, 0);
  EXPECT_LT(result.trust, 0.9);
  EXPECT_NEAR(result.correspondence.confidence[0], result.trust, 1e-12);
  EXPECT_NEAR(result.alternatives[0].correspondence.confidence[0], result.trust, 1e-12);
  EXPECT_NEAR(
      result.alternatives[1].correspondence.confidence[0], result.trust * std::exp(-0.5), 1e-12);
}

TEST(Attempts, aMapThatClosedHolesLedAstrayIsLeft) {
  const RegistrationResult result =
      withPatchedMap(resultWith(-12, 0.8, 1), resultWith(-10.5, 0.4, 2));
  EXPECT_EQ(result.correspondence.on_target[0].vertex, 1);
  EXPECT_EQ(result.deformed(0, 0), 1);
  EXPECT_DOUBLE_EQ(result.correspondence.confidence[0], 0.8);
}

}  // namespace
}  // namespace posture
