// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/error.h>
#include <posture/evaluation/truth.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/files.h"
#include <cmath>
#include <filesystem>
#include <fstream>

namespace posture {
namespace {

using testing::HasSubstr;

TEST(Truth, identity) {
  const auto pairs = readTruth("identity", 3, 3);
  ASSERT_EQ(pairs.size(), 3u);
  EXPECT_EQ(pairs[2].source, 2);
  EXPECT_EQ(pairs[2].target, 2);
  EXPECT_THAT(test::inputErrorOf([] { readTruth("identity", 3, 4); }),
              HasSubstr("3 source vertices"));
}

TEST(Truth, fileWithinRange) {
  const test::TemporaryFolder folder;
  const std::filesystem::path file = folder / "truth.txt";
  std::ofstream(file) << "0 5\n2 1\n";
  EXPECT_EQ(readTruth(file, 3, 6).size(), 2u);
  EXPECT_THAT(test::inputErrorOf([&] { readTruth(file, 2, 6); }), HasSubstr("source vertex 2"));
  EXPECT_THAT(test::inputErrorOf([&] { readTruth(file, 3, 5); }), HasSubstr("target vertex 5"));
  std::ofstream(file) << "# nothing\n";
  EXPECT_THAT(test::inputErrorOf([&] { readTruth(file, 3, 6); }), HasSubstr("truth.txt"));
  std::filesystem::remove(file);
  EXPECT_THROW(readTruth(file, 3, 6), InputError);
}

TEST(Truth, placesMustBeOnTheTarget) {
  TriangleMesh target;
  target.vertices = Points::Random(10, 3);
  target.vertices.row(9) = target.vertices.row(7);
  target.faces.resize(4, 3);
  target.faces << 0, 1, 2, 1, 2, 3, 4, 5, 6, 6, 7, 8;
  const auto check = [&](const SurfacePoint& place) {
    return test::inputErrorOf([&] { checkOnTarget("map.csv", {SurfacePoint{}, place}, target); });
  };
  EXPECT_EQ(check({8, 3, {0.5, 0.25, 0.25}}), "");
  EXPECT_EQ(check({9, 3, {0.5, 0.25, 0.25}}), "");  // where vertex 7 is
  EXPECT_EQ(check({9, -1, {0, 0, 0}}), "");
  EXPECT_THAT(check({10, -1, {0, 0, 0}}), HasSubstr("map.csv: row 1: target vertex 10"));
  EXPECT_THAT(check({9, 4, {1, 0, 0}}), HasSubstr("face 4"));
  EXPECT_THAT(check({5, 3, {1, 0, 0}}), HasSubstr("face 3 does not have the target vertex 5"));
  EXPECT_THAT(check({8, 3, {2, -1, 0}}), HasSubstr("barycentric"));
  EXPECT_THAT(check({8, 3, {std::nan(""), 0, 1}}), HasSubstr("barycentric"));
}

}  // namespace
}  // namespace posture
