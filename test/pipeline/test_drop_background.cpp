// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/pipeline/register_shapes.h>

#include <gtest/gtest.h>

#include "outcome/drop_background.h"
#include <algorithm>
#include <vector>

namespace posture {
namespace {

TEST(DropBackground, whatWasPutOntoAFloorHasNoCounterpart) {
  RegistrationResult result;
  result.correspondence.on_target.resize(3);
  for (int v = 0; v < 3; ++v) result.correspondence.on_target[v].vertex = std::min(v, 1);
  result.correspondence.confidence = Vector::Ones(3);
  result.back = WayBack{result.correspondence};
  const Background none, floor{1, {0, 1, 0}};
  dropBackground(none, Points::Zero(3, 3), floor, result);
  const auto places = [](const Correspondence& map) {
    std::vector<int> found;
    for (const SurfacePoint& place : map.on_target) found.push_back(place.vertex);
    return found;
  };
  EXPECT_EQ(places(result.correspondence), (std::vector<int>{0, -1, -1}));
  EXPECT_EQ(result.correspondence.confidence, Vector::Unit(3, 0));
  // There the floor is what has no row.
  EXPECT_EQ(places(result.back->correspondence), (std::vector<int>{0, -1, 1}));
}

}  // namespace
}  // namespace posture
