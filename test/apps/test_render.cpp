// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/io/mesh_io.h>

#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <apps/program.h>
#include <cmath>
#include <fstream>
#include <support/shapes.h>

namespace posture {
namespace {

using test::ProgramRun;

/// Where there is no display, the program has to bring its own.
ProgramRun render(const std::vector<std::string>& arguments) {
  return test::run(std::string(PROGRAM_DIR) + "/posture-render", arguments, {"DISPLAY"});
}

int bigEndian(const std::string& bytes, std::size_t place) {
  int value = 0;
  for (std::size_t k = 0; k < 4; ++k)
    value = value << 8 | static_cast<unsigned char>(bytes.at(place + k));
  return value;
}

class Render : public ::testing::Test {
 protected:
  void SetUp() override {
    TriangleMesh ball = test::sphere(3);
    writeMesh(folder_ / "ball.ply", ball);
    ball.vertices *= Eigen::Vector3d(3, 1, 1).asDiagonal();
    writeMesh(folder_ / "cigar.off", ball);
    writeMesh(folder_ / "cloud.ply", {ball.vertices, {}});
    Colors red(ball.vertices.rows(), 3);
    red.rowwise() = Colors::RowXpr::PlainObject(200, 0, 0);
    writeMesh(folder_ / "red.ply", ball, red);
    writeMesh(folder_ / "sheet.obj", test::grid(8, 4, 2, 1));
  }

  /// Share of pixels covered, tile by tile.
  std::vector<double> draw(std::vector<std::string> arguments) {
    arguments.insert(arguments.end(), {"-o", folder_ / "picture.png", "--json"});
    const ProgramRun ended = render(arguments);
    EXPECT_EQ(ended.exit_code, 0) << ended.err;
    EXPECT_EQ(ended.err, "");
    std::vector<double> covered;
    if (ended.exit_code != 0) return covered;
    const auto report = nlohmann::json::parse(ended.out);
    for (const auto& tile : report.at("tiles")) covered.push_back(tile.at("covered"));
    width_ = report.at("width");
    height_ = report.at("height");
    return covered;
  }

  std::string picture() const { return test::bytesOf(folder_ / "picture.png"); }

  test::TemporaryFolder folder_;
  int width_ = 0, height_ = 0;
};

TEST_F(Render, meshesAndCloudsInColumns) {
  const auto covered = draw(
      {folder_ / "ball.ply", folder_ / "cigar.off", folder_ / "cloud.ply", "--size", "200x150"});
  ASSERT_EQ(covered.size(), 3u);
  EXPECT_NEAR(covered[0], 0.456, 0.02);  // a disc of 0.88 of the tile's height
  EXPECT_GT(covered[1], 0.1);
  EXPECT_NEAR(covered[2], covered[1], 0.1);
  const std::string png = picture();
  EXPECT_EQ(png.substr(0, 8), "\x89PNG\r\n\x1a\n");
  EXPECT_EQ(bigEndian(png, 16), 600);
  EXPECT_EQ(bigEndian(png, 20), height_);
  EXPECT_GT(height_, 150);
}

TEST_F(Render, sameInputSameBytesOtherInputOtherBytes) {
  draw({folder_ / "cigar.off", "--size", "120x120"});
  const std::string first = picture();
  draw({folder_ / "cigar.off", "--size", "120x120", "--threads", "2", "--seed", "5", "--quiet"});
  EXPECT_EQ(first, picture());
  draw({folder_ / "red.ply", "--size", "120x120"});
  EXPECT_NE(first, picture());
}

TEST_F(Render, viewsAreRows) {
  const std::vector<std::string> views = {
      "--view", "front", "--view", "right", "--up", "y", "--size", "100x100"};
  std::vector<std::string> arguments = {folder_ / "cigar.off"};
  arguments.insert(arguments.end(), views.begin(), views.end());
  const auto covered = draw(arguments);
  ASSERT_EQ(covered.size(), 2u);
  EXPECT_LT(covered[0], 0.3);  // lengthwise
  EXPECT_GT(covered[1], 0.5);  // round
  EXPECT_GT(height_, 200);
}

TEST_F(Render, columnsWrap) {
  draw({folder_ / "ball.ply",
        folder_ / "red.ply",
        folder_ / "cloud.ply",
        "--columns",
        "2",
        "--size",
        "64x64"});
  EXPECT_EQ(width_, 128);
  EXPECT_GT(height_, 128);
}

TEST_F(Render, optionsShow) {
  const std::vector<std::string> plain = {
      folder_ / "ball.ply", folder_ / "sheet.obj", "--size", "100x100"};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.begin(), plain.begin(), plain.end());
    const auto covered = draw(more);
    return std::make_pair(covered, picture());
  };
  const auto usual = with({});
  EXPECT_GT(with({"--same-scale"}).first.at(0), 0.3);
  EXPECT_NE(with({"--same-scale"}).first, usual.first);
  EXPECT_NE(with({"--boundary"}).second, usual.second);
  EXPECT_LT(with({"--no-faces", "--point-size", "1"}).first.at(0), usual.first.at(0));
  EXPECT_NE(with({"--up", "x"}).second, usual.second);
}

TEST_F(Render, badFilesAreNamedInOneLine) {
  std::ofstream(folder_ / "bad.ply") << "ply\nformat ascii 1.0\nelement vertex 3\n";
  for (const std::string name : {"missing.ply", "bad.ply"}) {
    const ProgramRun ended = render({folder_ / name, "-o", folder_ / "never.png"});
    EXPECT_EQ(ended.exit_code, 3);
    EXPECT_TRUE(test::saidWhyInOneLine(ended)) << ended.err;
    EXPECT_NE(ended.err.find(name), std::string::npos) << ended.err;
  }
  const ProgramRun ended = render({folder_ / "ball.ply", "-o", folder_ / "no/folder.png"});
  EXPECT_EQ(ended.exit_code, 3);
  EXPECT_TRUE(test::saidWhyInOneLine(ended)) << ended.err;
  for (const std::string& name : folder_.names()) EXPECT_EQ(name.find("never"), std::string::npos);
}

TEST_F(Render, refusesWhatWouldBeBlank) {
  writeMesh(folder_ / "one-place.ply", {Points::Ones(3, 3), Faces{{0, 1, 2}}});
  for (const double unit : {1e300, 1e-300}) {
    TriangleMesh ball = test::sphere(1);
    ball.vertices *= unit;
    writeMesh(folder_ / (unit > 1 ? "large.ply" : "small.ply"), ball);
  }
  for (const auto& [name, why] :
       {std::pair<std::string, std::string>("one-place.ply", "there is nothing to see"),
        {"large.ply", "has coordinates too large to compute with"},
        {"small.ply", "is too small to compute with"}}) {
    const ProgramRun ended =
        render({folder_ / "ball.ply", folder_ / name, "-o", folder_ / "never.png"});
    EXPECT_EQ(ended.exit_code, 3) << name;
    EXPECT_TRUE(test::saidWhyInOneLine(ended)) << ended.err;
    EXPECT_NE(ended.err.find(name + ": " + why), std::string::npos) << ended.err;
  }
  for (const std::string& name : folder_.names()) EXPECT_EQ(name.find("never"), std::string::npos);
}

TEST_F(Render, drawsASinglePlaceAsADot) {
  writeMesh(folder_ / "point.ply", {Points::Zero(1, 3), {}});
  writeMesh(folder_ / "equal.ply", {Points::Constant(50, 3, 7), {}});
  constexpr double DOT = M_PI * 36 / (100 * 100);
  for (const double covered :
       draw({folder_ / "point.ply", folder_ / "equal.ply", "--size", "100x100"}))
    EXPECT_NEAR(covered, DOT, 0.3 * DOT);
}

TEST_F(Render, drawsLargeAndSmallUnits) {
  const std::vector<double> usual = draw({folder_ / "ball.ply"});
  for (const double unit : {1e-9, 1e9, 1e49}) {
    TriangleMesh ball = test::sphere(3);
    ball.vertices *= unit;
    writeMesh(folder_ / "scaled.ply", ball);
    EXPECT_NEAR(draw({folder_ / "scaled.ply"}).at(0), usual.at(0), 5e-3) << unit;
  }
}

TEST_F(Render, wrongUsage) {
  const std::string ball = folder_ / "ball.ply", out = folder_ / "never.png";
  const std::vector<std::vector<std::string>> wrong = {{},
                                                       {ball},
                                                       {"-o", out},
                                                       {ball, "-o", out, "--view", "inside"},
                                                       {ball, "-o", out, "--size", "12"},
                                                       {ball, "-o", out, "--size", "100x9999"},
                                                       {ball, "-o", out, "--columns", "0"},
                                                       {ball, "-o", out, "--up", "w"},
                                                       {ball, "-o", out, "--point-size", "nan"},
                                                       {ball, "-o", out, "--threads", "0"},
                                                       {ball, "-o", out, "--seed", "-1"},
                                                       {ball, "-o", folder_ / "picture.jpg"},
                                                       {ball, "-o", out, "--nonsense"}};
  for (const auto& arguments : wrong) {
    const ProgramRun ended = render(arguments);
    EXPECT_EQ(ended.exit_code, 2) << ended.err;
    EXPECT_TRUE(test::saidWhyInOneLine(ended)) << ended.err;
  }
}

TEST_F(Render, noDisplayToBeHad) {
  const ProgramRun ended = test::run(std::string(PROGRAM_DIR) + "/posture-render",
                                     {folder_ / "ball.ply", "-o", folder_ / "never.png"},
                                     {"DISPLAY", "PATH=/nowhere"});
  EXPECT_EQ(ended.exit_code, 3);
  EXPECT_TRUE(test::saidWhyInOneLine(ended)) << ended.err;
  EXPECT_NE(ended.err.find("Xvfb"), std::string::npos);
}

}  // namespace
}  // namespace posture
