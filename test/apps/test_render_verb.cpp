// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/io/mesh_io.h>

#include <gtest/gtest.h>

#include <apps/program.h>
#include <filesystem>
#include <support/shapes.h>

namespace posture {
namespace {

const std::string POSTURE = std::string(PROGRAM_DIR) + "/posture";

TEST(RenderVerb, handsEverythingOn) {
  const test::TemporaryFolder folder;
  writeMesh(folder / "ball.ply", test::sphere(2));
  const auto drawn = test::run(
      POSTURE,
      {"--json", "render", folder / "ball.ply", "-o", folder / "a.png", "--size", "64x64"});
  EXPECT_EQ(drawn.exit_code, 0) << drawn.err;
  EXPECT_EQ(drawn.out.front(), '{');
  EXPECT_EQ(test::bytesOf(folder / "a.png").substr(1, 3), "PNG");

  const auto help = test::run(POSTURE, {"render", "--help"});
  EXPECT_EQ(help.exit_code, 0);
  EXPECT_NE(help.out.find("--same-scale"), std::string::npos);
}

TEST(RenderVerb, handsExitCodesBack) {
  const test::TemporaryFolder folder;
  EXPECT_EQ(test::run(POSTURE, {"render"}).exit_code, 2);
  const auto missing =
      test::run(POSTURE, {"render", folder / "missing.ply", "-o", folder / "a.png"});
  EXPECT_EQ(missing.exit_code, 3);
  EXPECT_TRUE(test::saidWhyInOneLine(missing)) << missing.err;
}

TEST(RenderVerb, saysWhenThereIsNoRenderer) {
  const test::TemporaryFolder folder;
  std::filesystem::copy_file(POSTURE, folder / "posture");
  const auto ended = test::run(folder / "posture", {"render", "x.ply", "-o", folder / "a.png"});
  EXPECT_EQ(ended.exit_code, 3);
  EXPECT_TRUE(test::saidWhyInOneLine(ended)) << ended.err;
  EXPECT_NE(ended.err.find("posture-render"), std::string::npos);
}

}  // namespace
}  // namespace posture
