// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/error.h>

#include <gtest/gtest.h>

#include "sides/side_surface.h"
#include <optional>
#include <string>

namespace posture {
namespace {

TEST(SurfaceOf, namesTheSideThatCannotBeUsed) {
  try {
    surfaceOf("target",
              {{Points::Zero(5, 3), {}, {}, 0, std::nullopt}, {}},
              SurfaceMethod::TANGENT_DELAUNAY);
    FAIL() << "nothing thrown";
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()).rfind("target ", 0), 0U) << error.what();
  }
}

}  // namespace
}  // namespace posture
