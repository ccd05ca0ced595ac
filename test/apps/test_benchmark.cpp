// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/evaluation/pair_list.h>
#include <posture/io/mesh_io.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "apps/program.h"
#include "apps/strips.h"
#include <algorithm>
#include <filesystem>
#include <fstream>

namespace posture {
namespace {

using json = nlohmann::ordered_json;  // as the program writes it
using testing::HasSubstr;
using testing::Not;

namespace fs = std::filesystem;

const std::string POSTURE = std::string(PROGRAM_DIR) + "/posture";

/// A list of a strip bent two ways, a pair whose source is missing and a pair of points only, every
/// second one missing.
class Benchmark : public testing::Test {
 protected:
  void SetUp() override {
    fs::create_directories(folder_ / "m");
    writeMesh(folder_ / "m/flat.off", test::taperedStrip(0));
    writeMesh(folder_ / "m/bent.off", test::taperedStrip(1.5));
    std::ofstream points(folder_ / "m/points.xyz");
    for (int v = 0; v < 100; ++v) points << v << " " << v % 7 << " " << v % 5 << "\nnan nan nan\n";
    std::ofstream(folder_ / "pairs.csv")
        << "id,family,kind,source,target,truth,mirror_truth,note\n"
           "good,strip,isometric,m/flat.off,m/bent.off,identity,,\"a strip, bent\"\n"
           "missing,strip,isometric,m/none.off,m/bent.off,identity,,\n"
           "points,scans,scan,m/points.xyz,m/bent.off,,,\n";
  }

  test::ProgramRun benchmark(std::vector<std::string> more = {}) const {
    more.insert(more.begin(), {"benchmark", folder_ / "pairs.csv", "-o", out_.string()});
    return test::run(POSTURE, more);
  }

  /// As published: for what is the same by either method, in a fraction of the time.
  test::ProgramRun published(std::vector<std::string> more = {}) const {
    more.insert(more.begin(), "--paper");
    return benchmark(more);
  }

  const test::TemporaryFolder folder_;
  const fs::path out_ = folder_ / "results";
  const test::StoredResults result{out_ / "pairs"};
};

TEST_F(Benchmark, namesTheFileThatCannotBeUsed) {
  std::ofstream(folder_ / "m/line.off") << "OFF\n3 1 0\n0 0 0\n1 0 0\n2 0 0\n3 0 1 2\n";
  std::ofstream(folder_ / "pairs.csv") << "id,source,target\n"
                                          "from,m/line.off,m/bent.off\n"
                                          "onto,m/bent.off,m/line.off\n";
  published();
  for (const std::string pair : {"from", "onto"}) {
    EXPECT_EQ(result(pair)["status"], "not run");
    EXPECT_EQ(result(pair)["message"], folder_ / "m/line.off" + ": has only faces without area");
  }
}

TEST_F(Benchmark, oneBadPairDoesNotEndTheList) {
  const auto end = published();
  ASSERT_EQ(end.exit_code, 0) << end.err;
  EXPECT_EQ(std::count(end.err.begin(), end.err.end(), '\n'), 3) << end.err;  // a line a pair
  EXPECT_THAT(end.out, HasSubstr("3 pairs: "));

  const json good = result("good");
  EXPECT_THAT(good["status"], testing::AnyOf("registered", "undecided"));
  EXPECT_EQ(good["source_vertices"], 147);
  EXPECT_EQ(good["accepted"].get<int>() + good["rejected"].get<int>(), 147);
  EXPECT_EQ(good["errors"]["true_pairs"], 147);
  EXPECT_GE(good["candidates"]["errors"].size(), 1u);
  EXPECT_TRUE(good["fit"].contains("mean_stretch"));
  EXPECT_GT(good["seconds"], 0);
  EXPECT_GT(good["peak_memory_mib"], 1);
  EXPECT_FALSE(good["stages"].empty());
  EXPECT_EQ(result("missing")["status"], "not run");
  EXPECT_THAT(result("missing")["message"], HasSubstr("none.off"));
  // Points are no reason not to run.
  EXPECT_THAT(result("points")["status"], testing::AnyOf("registered", "undecided"));
  EXPECT_TRUE(result("points")["stages"].contains("surfaces"));
  EXPECT_EQ(result("points")["source_vertices"], 100) << "the missing ones are none";
  EXPECT_EQ(result("points")["accepted"].get<int>() + result("points")["rejected"].get<int>(), 100);

  const auto rows = parseCsv(test::bytesOf(out_ / "results.csv"));
  ASSERT_EQ(rows.size(), 4u);
  EXPECT_EQ(rows[1][0], "good");
  EXPECT_EQ(rows[3].size(), rows[0].size());
  const std::string page = test::bytesOf(out_ / "RESULTS.md");
  for (const char* part : {"| strip ", "| scans ", "| points "}) EXPECT_THAT(page, HasSubstr(part));
  EXPECT_THAT(page, Not(HasSubstr("## The paper's own figures"))) << "it has no such families";
  EXPECT_EQ(json::parse(test::bytesOf(out_ / "results.json"))["pairs"].size(), 3u);
  EXPECT_THAT(test::bytesOf(out_ / "curves.svg"), HasSubstr("<svg"));
  EXPECT_THAT(test::bytesOf(out_ / "histogram.svg"), HasSubstr("<svg"));
  for (const auto& entry : fs::directory_iterator(out_ / "pairs"))
    EXPECT_EQ(entry.path().extension(), ".json");  // no logs, no half-written files
}

TEST_F(Benchmark, anIdMayLookLikeAnOption) {
  std::ofstream(folder_ / "pairs.csv") << "id,source,target\n-h,m/flat.off,m/bent.off\n";
  const auto end = published({"--json", "-q"});
  ASSERT_EQ(end.exit_code, 0) << end.err;
  EXPECT_EQ(json::parse(end.out)["pairs"].size(), 1U);
  EXPECT_THAT(result("-h")["status"], testing::AnyOf("registered", "undecided"));
}

TEST_F(Benchmark, theRefinedMethodIsTheDefault) {
  const auto end = benchmark({"--pair", "good"});
  ASSERT_EQ(end.exit_code, 0) << end.err;
  EXPECT_EQ(result("good")["method"], "refined");
  EXPECT_GT(result("good")["trust"], 0);
  EXPECT_GE(result("good")["candidates"]["errors"].size(), 1u);
  EXPECT_LT(result("good")["errors"]["mean_x100"], 5);
}

TEST_F(Benchmark, runsWhereItsParentIgnoresTheEndOfChildren) {
  const auto end = test::run("/bin/bash",  // dash takes it back
                             {"-c",
                              R"(trap '' CHLD; exec "$0" "$@")",
                              POSTURE,
                              "benchmark",
                              folder_ / "pairs.csv",
                              "-o",
                              out_.string(),
                              "--pair",
                              "good"});
  ASSERT_EQ(end.exit_code, 0) << end.err;
  EXPECT_EQ(result("good")["status"], "registered") << result("good")["message"];
  EXPECT_LT(result("good")["errors"]["mean_x100"], 5);
}

TEST_F(Benchmark, familiesOfThePaperStandBesideItsFigures) {
  std::ofstream(folder_ / "pairs.csv") << "id,family,source,target,truth\n"
                                          "good,horse,m/flat.off,m/bent.off,identity\n";
  ASSERT_EQ(published().exit_code, 0);
  EXPECT_THAT(test::bytesOf(out_ / "RESULTS.md"), HasSubstr("## The paper's own figures"));
}

TEST_F(Benchmark, textsThatAreNoUtf8AreRefusedBeforeAnythingRuns) {
  std::ofstream(folder_ / "pairs.csv", std::ios::app) << "latin,,,m/flat.off,m/bent.off,,,K\xe4"
                                                         "fer\n";
  const auto end = published();
  EXPECT_EQ(end.exit_code, 3);
  EXPECT_THAT(end.err, HasSubstr("pairs.csv: pair latin"));
  EXPECT_FALSE(fs::exists(out_));
}

TEST_F(Benchmark, whatTookTooLongIsRunAgain) {
  ASSERT_EQ(published({"--pair", "good", "--time-limit", "0.001"}).exit_code, 0);
  EXPECT_EQ(result("good")["status"], "failed");
  ASSERT_EQ(published({"--pair", "good"}).exit_code, 0);
  EXPECT_NE(result("good")["status"], "failed");
}

TEST_F(Benchmark, theListMayComeBehindAnOption) {
  const auto end = test::run(POSTURE,
                             {"benchmark",
                              "--paper",
                              "-o",
                              out_.string(),
                              "--pair",
                              "missing",
                              "--pair",
                              "good",
                              folder_ / "pairs.csv"});
  ASSERT_EQ(end.exit_code, 0) << end.err;
  EXPECT_TRUE(fs::exists(out_ / "pairs/good.json"));
}

TEST_F(Benchmark, resumesWhereItStopped) {
  ASSERT_EQ(published({"--pair", "good", "--pair", "points"}).exit_code, 0);
  EXPECT_FALSE(fs::exists(out_ / "pairs/missing.json"));
  const auto good = result.written("good"), points = result.written("points");

  const auto again = published();
  EXPECT_EQ(again.exit_code, 0);
  EXPECT_EQ(std::count(again.err.begin(), again.err.end(), '\n'), 1) << again.err;
  EXPECT_EQ(result.written("good"), good);
  EXPECT_EQ(result.written("points"), points);
  EXPECT_TRUE(fs::exists(out_ / "pairs/missing.json"));

  EXPECT_EQ(published({"--fresh", "--family", "scans"}).exit_code, 0);
  EXPECT_EQ(result.written("good"), good);
  EXPECT_NE(result.written("points"), points);
  EXPECT_EQ(parseCsv(test::bytesOf(out_ / "results.csv")).size(), 4u);
}

TEST_F(Benchmark, runsAgainWhatIsDamagedOrOfOtherInputs) {
  ASSERT_EQ(published({"--pair", "points"}).exit_code, 0);
  std::ofstream(out_ / "pairs/points.json") << "{\"id\": \"poi";
  ASSERT_EQ(published({"--pair", "points"}).exit_code, 0);
  EXPECT_TRUE(result("points").contains("stages"));

  std::ofstream(folder_ / "pairs.csv") << "id,source,target\npoints,m/other.xyz,m/bent.off\n";
  ASSERT_EQ(published().exit_code, 0);
  EXPECT_THAT(result("points")["message"], HasSubstr("other.xyz"));
  fs::copy(folder_ / "m/points.xyz", folder_ / "m/other.xyz");
  ASSERT_EQ(published().exit_code, 0);
  EXPECT_TRUE(result("points").contains("stages")) << "of the file as it was";

  // By the other method, which is cut short here.
  ASSERT_EQ(benchmark({"--time-limit", "0.001"}).exit_code, 0);
  EXPECT_EQ(result("points")["status"], "failed");
}

TEST_F(Benchmark, aPairThatTakesTooLongHasFailed) {
  ASSERT_EQ(benchmark({"--quiet", "--pair", "good", "--time-limit", "0.001"}).exit_code, 0);
  EXPECT_EQ(result("good")["status"], "failed");
  EXPECT_THAT(result("good")["message"], HasSubstr("took longer than"));
}

TEST_F(Benchmark, quietAndJson) {
  const auto quiet = published({"--quiet", "--pair", "points"});
  EXPECT_EQ(quiet.out + quiet.err, "");
  const auto as_json = published({"--quiet", "--json"});
  EXPECT_EQ(as_json.err, "");
  EXPECT_EQ(json::parse(as_json.out)["pairs"].size(), 3u);
}

TEST_F(Benchmark, saysWhatItCannotUse) {
  const auto unknown = benchmark({"--family", "cat"});
  EXPECT_EQ(unknown.exit_code, 2);
  EXPECT_THAT(unknown.err, HasSubstr("no family 'cat'"));
  const auto nothing = benchmark({"--family", "strip", "--pair", "points"});
  EXPECT_EQ(nothing.exit_code, 2);
  EXPECT_THAT(nothing.err, HasSubstr("no pair asked for is of a family asked for"));
  std::ofstream(folder_ / "pairs.csv") << "id,source\na,b\n";
  const auto broken = benchmark();
  EXPECT_EQ(broken.exit_code, 3);
  EXPECT_THAT(broken.err, HasSubstr("pairs.csv: has no column 'target'"));
  EXPECT_EQ(std::count(broken.err.begin(), broken.err.end(), '\n'), 1);
  fs::remove(folder_ / "pairs.csv");
  EXPECT_EQ(benchmark().exit_code, 3);
}

}  // namespace
}  // namespace posture
