// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "attempts.h"

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

TEST(Attempts, aMapThatClosedHolesLedAstrayIsLeft) {
  const RegistrationResult result =
      withPatchedMap(resultWith(-12, 0.8, 1), resultWith(-10.5, 0.4, 2));
  EXPECT_EQ(result.correspondence.on_target[0].vertex, 1);
  EXPECT_EQ(result.deformed(0, 0), 1);
  EXPECT_DOUBLE_EQ(result.correspondence.confidence[0], 0.8);
}

}  // namespace
}  // namespace posture
