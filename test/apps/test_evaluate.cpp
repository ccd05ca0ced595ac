// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/io/correspondence_io.h>
#include <posture/io/mesh_io.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "apps/program.h"
#include "support/shapes.h"
#include <algorithm>
#include <cmath>
#include <fstream>

namespace posture {
namespace {

using nlohmann::json;
using testing::HasSubstr;

const std::string POSTURE = std::string(PROGRAM_DIR) + "/posture";
constexpr int COLUMNS = 20, ROWS = 10, VERTICES = (COLUMNS + 1) * (ROWS + 1);

class Evaluate : public testing::Test {
 protected:
  void SetUp() override {
    writeMesh(folder_ / "target.off", test::grid(COLUMNS, ROWS, COLUMNS, ROWS));
    writeMap("identity.csv", 0);
    writeMap("shifted.csv", 1);
    std::vector<VertexPair> mirrored;
    for (int v = 0; v < VERTICES; ++v)
      mirrored.push_back({v, v - v % (COLUMNS + 1) + COLUMNS - v % (COLUMNS + 1)});
    writeVertexPairs(folder_ / "mirror.txt", mirrored);
  }

  /// Every vertex goes so many columns to the right, or nowhere where there is none.
  void writeMap(const std::string& name, int columns) const {
    Correspondence map;
    map.on_target.resize(VERTICES);
    map.confidence = Vector::Zero(VERTICES);
    for (int v = 0; v < VERTICES; ++v)
      if (v % (COLUMNS + 1) + columns <= COLUMNS) {
        map.on_target[v].vertex = v + columns;
        map.confidence[v] = 1;
      }
    writeCorrespondence(folder_ / name, map);
  }

  test::ProgramRun evaluate(const std::string& map, std::vector<std::string> more) const {
    more.insert(more.begin(), {"evaluate", folder_ / map});
    if (std::find(more.begin(), more.end(), "--target") == more.end())
      more.insert(more.end(), {"--target", folder_ / "target.off"});
    return test::run(POSTURE, more);
  }

  void expectInputError(const test::ProgramRun& end, const std::string& what) const {
    EXPECT_EQ(end.exit_code, 3);
    EXPECT_THAT(end.err, HasSubstr(what));
    EXPECT_TRUE(test::saidWhyInOneLine(end)) << end.err;
  }

  const test::TemporaryFolder folder_;
};

TEST_F(Evaluate, printsTheFigures) {
  const auto end = evaluate("identity.csv", {"--truth", "identity"});
  EXPECT_EQ(end.exit_code, 0) << end.err;
  EXPECT_THAT(end.out, HasSubstr("mean error x100        0.000\n"));
  EXPECT_THAT(end.out, HasSubstr("within two edges       100.0 %\n"));
  EXPECT_THAT(end.out, HasSubstr("accepted               231 of 231 (100.0 %), 0 rejected\n"));
}

TEST_F(Evaluate, measuresAtVerticesAndBesideThatInFaces) {
  const TriangleMesh target = test::grid(COLUMNS, ROWS, COLUMNS, ROWS);
  Correspondence map;
  map.on_target.resize(VERTICES);
  map.confidence = Vector::Ones(VERTICES);
  for (int f = 0; f < target.faces.rows(); ++f) {
    SurfacePoint& place = map.on_target[target.faces(f, 0)];
    place.vertex = target.faces(f, 0);
    place.face = f;
    place.barycentric = {0.6, 0.4, 0};
  }
  int mapped = 0;
  for (const SurfacePoint& place : map.on_target) mapped += place.vertex >= 0;
  ASSERT_GT(mapped, 100);
  writeCorrespondence(folder_ / "between.csv", map);
  const auto end = evaluate("between.csv", {"--truth", "identity"});
  EXPECT_EQ(end.exit_code, 0) << end.err;
  EXPECT_THAT(end.out, HasSubstr("mean error x100        0.000\n"));
  EXPECT_THAT(end.out, testing::ContainsRegex("mean x100 in faces     [2-5][.]"));
}

TEST_F(Evaluate, writesJson) {
  const auto end = evaluate("shifted.csv",
                            {"--json", "--truth", "identity", "--mirror", folder_ / "mirror.txt"});
  ASSERT_EQ(end.exit_code, 0) << end.err;
  const json figures = json::parse(end.out);
  EXPECT_NEAR(figures["mean_x100"], 100 / std::sqrt(200.0), 0.1);
  EXPECT_EQ(figures["accepted"], COLUMNS * (ROWS + 1));
  EXPECT_EQ(figures["rejected"], ROWS + 1);
  EXPECT_EQ(figures["edge_histogram"], (std::vector<int>{0, COLUMNS * (ROWS + 1)}));
  EXPECT_EQ(figures["mirror"]["wrong_side"], false);
}

TEST_F(Evaluate, noSideIsRightWhereNothingIsMapped) {
  writeMap("nothing.csv", COLUMNS + 1);
  const std::vector<std::string> truths{"--truth", "identity", "--mirror", folder_ / "mirror.txt"};
  const auto end = evaluate("nothing.csv", truths);
  EXPECT_EQ(end.exit_code, 0) << end.err;
  EXPECT_THAT(end.out, testing::Not(HasSubstr("side ")));
}

TEST_F(Evaluate, quietPrintsJsonAlone) {
  const auto quiet = evaluate("identity.csv", {"--truth", "identity", "--quiet"});
  EXPECT_EQ(quiet.exit_code, 0);
  EXPECT_EQ(quiet.out + quiet.err, "");
  const auto as_json = evaluate("identity.csv", {"--truth", "identity", "--quiet", "--json"});
  EXPECT_TRUE(json::parse(as_json.out).contains("mean_x100"));
}

TEST_F(Evaluate, writesFiles) {
  const auto end = evaluate("shifted.csv", {"--truth", "identity", "-o", folder_ / "out/new"});
  ASSERT_EQ(end.exit_code, 0) << end.err;
  const auto text = [&](const std::string& name) {
    return test::bytesOf(folder_ / ("out/new/" + name));
  };
  EXPECT_TRUE(json::parse(text("evaluation.json")).contains("curve"));
  EXPECT_THAT(text("curve.csv"), testing::StartsWith("error,share_below\n0.0000,"));
  EXPECT_THAT(text("curve.svg"), HasSubstr("<svg"));
  EXPECT_THAT(text("histogram.svg"), HasSubstr("<svg"));
}

TEST_F(Evaluate, aFaceMayHaveAnotherCopyOfAVertexThatRoundingTookApart) {
  // Two halves, the seam between them rounded: the vertex is of the one, the face of the other.
  const TriangleMesh half = test::grid(COLUMNS / 2, ROWS, COLUMNS / 2.0, ROWS);
  const auto n = half.vertices.rows(), m = half.faces.rows();
  const TriangleMesh both = test::joined(half, test::shifted(half, {COLUMNS / 2.0 + 1e-6, 0, 0}));
  writeMesh(folder_ / "torn.ply", both);
  const int copy = both.faces(m, 0), vertex = copy - static_cast<int>(n) + COLUMNS / 2;
  ASSERT_NEAR((both.vertices.row(copy) - both.vertices.row(vertex)).norm(), 1e-6, 1e-9);
  Correspondence map;
  map.on_target.resize(2 * n);
  map.confidence = Vector::Zero(2 * n);
  map.on_target[vertex] = {vertex, static_cast<int>(m), {1, 0, 0}};
  writeCorrespondence(folder_ / "torn.csv", map);
  const auto on = [&](int target) {
    map.on_target[vertex].vertex = target;
    writeCorrespondence(folder_ / "torn.csv", map);
    return evaluate("torn.csv", {"--truth", "identity", "--target", folder_ / "torn.ply"});
  };
  EXPECT_EQ(on(vertex).exit_code, 0);
  expectInputError(on(vertex - 1), "does not have the target vertex");
}

TEST_F(Evaluate, nothingMappedIsNoError) {
  writeMap("none.csv", COLUMNS + 1);
  const auto end = evaluate("none.csv", {"--truth", "identity", "-o", folder_ / "out"});
  EXPECT_EQ(end.exit_code, 0) << end.err;
  EXPECT_THAT(end.out, HasSubstr("mean error x100        -\n"));
}

TEST_F(Evaluate, aTargetThatLacksAPartIsMeasuredOnTheWhole) {
  TriangleMesh part = test::grid(COLUMNS, ROWS, COLUMNS, ROWS);
  part.faces.conservativeResize(part.faces.rows() / 4, 3);
  writeMesh(folder_ / "part.off", part);
  const auto of = [&](std::vector<std::string> more) {
    more.insert(more.end(), {"--json", "--truth", "identity"});
    return json::parse(evaluate("shifted.csv", more).out);
  };
  const json whole = of({}),
             part_on_whole =
                 of({"--target", folder_ / "part.off", "--surface", folder_ / "target.off"});
  EXPECT_EQ(part_on_whole["mean_x100"], whole["mean_x100"]);
  EXPECT_EQ(part_on_whole["accepted"], whole["accepted"]);
  EXPECT_GT(of({"--target", folder_ / "part.off"})["mean_x100"],
            1.5 * whole["mean_x100"].get<double>());
}

TEST_F(Evaluate, aScanWithAFloorIsMeasuredOnTheBody) {
  const Points body = test::grid(COLUMNS, ROWS, COLUMNS, ROWS).vertices;
  std::ofstream scan(folder_ / "scan.xyz"), truth(folder_ / "truth.txt"),
      rows(folder_ / "rows.txt");
  for (int v = 0; v < VERTICES; ++v) {
    scan << body.row(v) << '\n';
    truth << v << ' ' << v << '\n';
    if (v < VERTICES / 2) rows << v << ' ' << v << '\n';
  }
  for (int i = 0; i < 2 * VERTICES; ++i) scan << i % 40 << ' ' << i / 40 << " -30\n";
  scan.close();
  truth.close();
  rows.close();
  const auto of = [&](std::vector<std::string> more) {
    more.insert(more.end(),
                {"--json",
                 "--truth",
                 folder_ / "truth.txt",
                 "--target",
                 folder_ / "scan.xyz",
                 "--surface",
                 folder_ / "target.off"});
    return json::parse(evaluate("identity.csv", more).out);
  };
  // Points without a row are at the nearest vertex; a counterpart there is one like others.
  for (const json& judged : {of({}), of({"--surface-vertices", folder_ / "rows.txt"})}) {
    EXPECT_EQ(judged["mean_x100"], 0);
    EXPECT_EQ(judged["accepted"], VERTICES);
    EXPECT_EQ(judged["mapped_pairs"], VERTICES);
  }
}

TEST_F(Evaluate, badInputIsOneLine) {
  std::ofstream(folder_ / "far.txt") << "0 0\n1 231\n";
  std::ofstream(folder_ / "cloud.off") << "OFF\n231 0 0\n"
                                       << [] {
                                            std::string rows;
                                            for (int v = 0; v < VERTICES; ++v)
                                              rows += std::to_string(v) + " 0 0\n";
                                            return rows;
                                          }();
  expectInputError(evaluate("none.csv", {"--truth", "identity"}), "none.csv");
  expectInputError(evaluate("identity.csv", {"--truth", folder_ / "none.txt"}), "none.txt");
  expectInputError(evaluate("identity.csv", {"--truth", folder_ / "far.txt"}), "target vertex 231");
  const std::string whole = test::bytesOf(folder_ / "identity.csv");
  std::ofstream(folder_ / "cut.csv") << whole.substr(0, whole.find("\n9,") + 1);
  expectInputError(evaluate("cut.csv", {"--truth", "identity"}), "cut.csv: 9");
  expectInputError(
      evaluate("identity.csv", {"--truth", "identity", "--mirror", folder_ / "far.txt"}),
      "target vertex 231");
  writeMesh(folder_ / "small.off", test::grid(4, 4, 1, 1));
  expectInputError(
      evaluate("identity.csv", {"--truth", "identity", "--target", folder_ / "small.off"}),
      "identity.csv: row 25: target vertex 25");
  expectInputError(
      evaluate("identity.csv", {"--truth", "identity", "--target", folder_ / "cloud.off"}),
      "cloud.off: has all its points on one line");
  TriangleMesh scaled = test::grid(COLUMNS, ROWS, COLUMNS, ROWS);
  scaled.vertices *= 1000;
  scaled.vertices.array() += 500;
  writeMesh(folder_ / "scaled.off", scaled);
  expectInputError(
      evaluate("identity.csv", {"--truth", "identity", "--surface", folder_ / "scaled.off"}),
      "target.off is: in another unit, or another frame?");
  std::filesystem::copy_file(folder_ / "identity.csv", folder_ / "curve.csv");
  const std::string before = test::bytesOf(folder_ / "curve.csv");
  expectInputError(evaluate("curve.csv", {"--truth", "identity", "-o", folder_.path().string()}),
                   "curve.csv: would be written over");
  EXPECT_EQ(test::bytesOf(folder_ / "curve.csv"), before);
}

TEST_F(Evaluate, wrongUsageIsTwo) {
  EXPECT_EQ(evaluate("identity.csv", {}).exit_code, 2);
  EXPECT_EQ(evaluate("identity.csv", {"--truth", "identity", "--nonsense"}).exit_code, 2);
}

}  // namespace
}  // namespace posture
