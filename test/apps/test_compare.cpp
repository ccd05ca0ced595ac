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
#include <csignal>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace posture {
namespace {

using json = nlohmann::ordered_json;  // as the program writes it
using testing::AnyOf;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;

namespace fs = std::filesystem;

const std::string POSTURE = std::string(PROGRAM_DIR) + "/posture";
constexpr int VERTICES = 147;

/// A strip, the same moved a little, and the same bent.
class Compare : public testing::Test {
 protected:
  void SetUp() override {
    const TriangleMesh flat = test::taperedStrip(0);
    TriangleMesh moved = flat;
    moved.vertices.rowwise() += Eigen::RowVector3d(0.03, -0.02, 0.04);
    writeMesh(folder_ / "flat.off", flat);
    writeMesh(folder_ / "moved.off", moved);
    writeMesh(folder_ / "bent.off", test::taperedStrip(1.5));
    std::ofstream(folder_ / "pairs.csv") << "id,family,kind,source,target,truth\n"
                                            "rigid,stiff,rigid,flat.off,moved.off,identity\n"
                                            "bent,soft,isometric,flat.off,bent.off,identity\n"
                                            "missing,soft,isometric,none.off,bent.off,identity\n";
  }

  test::ProgramRun compare(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), "compare");
    arguments.insert(arguments.end(), {"-o", out_.string()});
    return test::run(POSTURE, arguments);
  }

  /// The quick methods alone.
  test::ProgramRun comparePairs(std::vector<std::string> more = {}) const {
    more.insert(more.begin(), {folder_ / "pairs.csv", "--method", "as-given", "--method", "icp"});
    return compare(more);
  }

  /// Puts a result there as if the method had been run: that of as-given with other figures.
  /// \param figures  null takes one away.
  void store(const std::string& pair, const std::string& method, const json& figures) const {
    json run = result(pair + ".as-given");
    run["method"] = method;
    run.merge_patch(figures);
    std::ofstream(out_ / "runs" / (pair + "." + method + ".json")) << run;
  }

  void storeError(const std::string& pair,
                  const std::string& method,
                  double error,
                  double with_misses,
                  int mapped = VERTICES) const {
    store(pair,
          method,
          {{"errors",
            {{"mean_x100", error},
             {"mean_with_misses_x100", with_misses},
             {"mapped_pairs", mapped}}}});
  }

  /// Summed up from the results that are there.
  std::string summary(const std::string& list_or_pair) const {
    std::vector<std::string> arguments{"--method", "as-given"};
    if (list_or_pair == "pair")
      arguments.insert(arguments.begin(),
                       {folder_ / "flat.off", folder_ / "moved.off", "--truth", "identity"});
    else
      arguments.insert(arguments.begin(), folder_ / "pairs.csv");
    const auto end = compare(arguments);
    EXPECT_EQ(end.exit_code, 0) << end.err;
    return end.out;
  }

  const test::TemporaryFolder folder_;
  const fs::path out_ = folder_ / "results";
  const test::StoredResults result{out_ / "runs"};
};

TEST_F(Compare, aPairByEveryMethod) {
  const auto end = compare({folder_ / "flat.off",
                            folder_ / "moved.off",
                            "--truth",
                            "identity",
                            "--variation",
                            "aligned"});
  ASSERT_EQ(end.exit_code, 0) << end.err;
  for (const char* method :
       {"posture", "as given", "ICP", "ICP point to plane", "GICP", "NDT", "FPFH + ICP"})
    EXPECT_THAT(end.out, HasSubstr(method));

  const json icp = result("pair.aligned.icp");
  EXPECT_EQ(icp["status"], "converged");
  EXPECT_LT(icp["errors"]["mean_x100"], 0.1);  // a shift within the capture of ICP
  EXPECT_EQ(icp["errors"]["mapped_pairs"], VERTICES);
  EXPECT_EQ(icp["stretch"], 0);
  EXPECT_LT(icp["mean_distance"], 1e-3);
  EXPECT_EQ(icp["source_near"], 1);
  EXPECT_GT(icp["seconds"], 0);
  EXPECT_GT(icp["peak_memory_mib"], 1);
  EXPECT_GT(result("pair.aligned.as-given")["mean_distance"], icp["mean_distance"]);
  EXPECT_EQ(result("pair.aligned.as-given")["status"], "as given");

  const auto rows = parseCsv(test::bytesOf(out_ / "comparison.csv"));
  ASSERT_EQ(rows.size(), 8u);
  EXPECT_EQ(json::parse(test::bytesOf(out_ / "comparison.json"))["runs"].size(), 7u);
  EXPECT_THAT(test::bytesOf(out_ / "comparison.md"), HasSubstr("curves-aligned.svg"));
  EXPECT_THAT(test::bytesOf(out_ / "curves-aligned.svg"), HasSubstr("FPFH + ICP"));
}

TEST_F(Compare, mirroredAnswersAreToldFromTrueOnes) {
  std::ofstream mirror(folder_ / "mirror.txt");
  for (int v = 0; v < VERTICES; ++v) mirror << v << " " << VERTICES - 1 - v << "\n";
  mirror.close();
  const auto end = compare({folder_ / "flat.off",
                            folder_ / "moved.off",
                            "--truth",
                            "identity",
                            "--mirror",
                            folder_ / "mirror.txt",
                            "--method",
                            "as-given",
                            "--variation",
                            "aligned"});
  ASSERT_EQ(end.exit_code, 0) << end.err;
  EXPECT_EQ(result("pair.aligned.as-given")["mirror"]["wrong_side"], false);
  EXPECT_THAT(end.out, HasSubstr(" right "));

  const auto mirrored = compare({folder_ / "flat.off",
                                 folder_ / "moved.off",
                                 "--truth",
                                 folder_ / "mirror.txt",
                                 "--mirror",
                                 "identity",
                                 "--method",
                                 "as-given",
                                 "--variation",
                                 "aligned"});
  ASSERT_EQ(mirrored.exit_code, 0) << mirrored.err;
  EXPECT_EQ(result("pair.aligned.as-given")["mirror"]["wrong_side"], true);
  EXPECT_THAT(mirrored.out, HasSubstr(" wrong "));
}

/// A body that holds still, in noise: what rigid methods are made for.
TEST_F(Compare, rigidMethodsAreBestWhereABodyHeldStill) {
  const auto end = compare({DATA_DIR "/rigid/pairs.csv",
                            "--variation",
                            "aligned",
                            "--method",
                            "posture",
                            "--method",
                            "as-given",
                            "--method",
                            "icp",
                            "--method",
                            "gicp"});
  ASSERT_EQ(end.exit_code, 0) << end.err;
  EXPECT_THAT(end.out, HasSubstr("Source aligned: the best method"));
  EXPECT_THAT(
      end.out,
      AnyOf(HasSubstr(" is ICP, "), HasSubstr(" is GICP, "), HasSubstr(" are ICP and GICP, ")));
  const auto error = [this](const std::string& method) -> double {
    return result("quadruped-rigid.aligned." + method)["errors"]["mean_with_misses_x100"];
  };
  EXPECT_LT(error("icp"), 0.5 * error("posture"));
  EXPECT_LT(error("posture"), 0.5 * error("as-given"));
  EXPECT_EQ(result("quadruped-rigid.aligned.icp")["mirror"]["wrong_side"], false);
}

TEST_F(Compare, whereABentBodyIsIsNothingToPosture) {
  const auto made = test::run(POSTURE,
                              {"synthesize",
                               "--kind",
                               "human",
                               "--pose",
                               "0",
                               "6",
                               "--tessellation",
                               "0",
                               "1",
                               "--vertices",
                               "1000",
                               "-o",
                               folder_ / "bodies"});
  ASSERT_EQ(made.exit_code, 0) << made.err;
  const auto end =
      compare({folder_ / "bodies/pairs.csv", "--method", "posture", "--method", "icp"});
  ASSERT_EQ(end.exit_code, 0) << end.err;
  const auto error = [this](const std::string& variation, const std::string& method) -> double {
    return result("human-pose0-pose6." + variation + "." + method)["errors"]["mean_x100"];
  };
  const double ours = error("aligned", "posture"), icp = error("aligned", "icp");
  EXPECT_LT(ours, 2);
  EXPECT_GT(icp, 4 * ours);
  for (const char* variation : {"turned", "scaled"}) {
    EXPECT_NEAR(error(variation, "posture"), ours, 0.02 * ours) << variation;
    EXPECT_GT(error(variation, "icp"), 1.02 * icp) << variation;
  }
  for (const char* variation : {"aligned", "turned", "scaled"})
    EXPECT_THAT(end.out,
                HasSubstr("Source " + std::string(variation) + ": the best method is posture, "));
}

TEST_F(Compare, leavingPointsOutDoesNotWin) {
  summary("pair");
  storeError("pair.aligned", "as-given", 5, 5);
  storeError("pair.aligned", "posture", 0.1, 12.55, VERTICES / 2);
  storeError("pair.aligned", "icp", 1, 1);
  const std::string words = summary("pair");
  EXPECT_THAT(words,
              HasSubstr("Source aligned: the best method is ICP, error with misses 1.00; "
                        "next as given, 5.00; posture, 12.55."));
  EXPECT_THAT(words, HasSubstr("49.7 %        12.55"));
  EXPECT_THAT(words, HasSubstr("100.0 %         1.00"));
}

TEST_F(Compare, refusingAPairThatOthersAnswerDoesNotWin) {
  summary("list");
  for (const char* pair : {"rigid.aligned", "bent.aligned"}) {
    storeError(pair, "as-given", 5, 5);
    storeError(pair, "icp", 1, 1);
  }
  storeError("rigid.aligned", "gicp", 0.5, 0.5);
  store("bent.aligned", "gicp", {{"errors", nullptr}, {"status", "refused"}});
  // What cannot be read is nobody's miss.
  store("missing.aligned", "icp", {{"errors", nullptr}, {"status", "not run"}});
  const std::string words = summary("list");
  EXPECT_THAT(words, ContainsRegex("aligned +ICP [^\n]* 1\\.00 +- "));
  EXPECT_THAT(words, ContainsRegex("aligned +GICP [^\n]* 50\\.0 % +12\\.75 +- "));
}

TEST_F(Compare, equalMethodsShareThePlace) {
  summary("pair");
  storeError("pair.aligned", "as-given", 5, 5);
  storeError("pair.aligned", "posture", 1, 1.001);
  storeError("pair.aligned", "icp", 1, 1);
  storeError("pair.aligned", "gicp", 1, 1.003);
  storeError("pair.turned", "as-given", 5, 5);
  storeError("pair.turned", "icp", 5, 5);
  const std::string words = summary("pair");
  EXPECT_THAT(words, HasSubstr("aligned: the best methods are ICP, posture and GICP, "));
  EXPECT_THAT(words, HasSubstr("turned: no method improves on the source as given, "));
}

TEST_F(Compare, pairsOnWhichPostureFailedAreNamed) {
  summary("list");
  for (const char* pair : {"rigid.aligned", "bent.aligned"}) {
    storeError(pair, "as-given", 5, 5);
    storeError(pair, "icp", 1, 1);
  }
  store("rigid.aligned", "posture", {{"status", "failed"}, {"errors", nullptr}});
  storeError("bent.aligned", "posture", 0.5, 0.5);
  const std::string words = summary("list");
  EXPECT_THAT(words,
              HasSubstr("Source aligned: of 2 pairs with a truth, the best method is ICP on 1, "
                        "posture on 1. Another is better than posture on rigid (ICP 1.00, posture "
                        "failed)."));
  EXPECT_THAT(words, HasSubstr(" 12.75 ")) << "a failed run misses all of the truth";

  summary("pair");
  store("pair.aligned", "posture", {{"status", "failed"}, {"errors", nullptr}});
  EXPECT_THAT(summary("pair"),
              HasSubstr("no method improves on the source as given, error with misses 0.00; "
                        "posture failed.\n"));
}

TEST_F(Compare, changesWithoutANumberAreNamed) {
  summary("pair");
  storeError("pair.aligned", "icp", 1, 1);
  store("pair.turned", "icp", {{"status", "failed"}, {"errors", nullptr}});
  storeError("pair.aligned", "gicp", 0, 0);
  storeError("pair.turned", "gicp", 3, 3);
  storeError("pair.aligned", "ndt", 0, 0);
  storeError("pair.turned", "ndt", 0, 0);
  storeError("pair.aligned", "posture", 1, 1);
  storeError("pair.turned", "posture", 1.5, 1.5);
  const std::string words = summary("pair");
  const auto turnedRow = [&](const std::string& method) {
    std::istringstream lines(words);
    for (std::string line; std::getline(lines, line);)
      if (line.rfind("turned", 0) == 0 && line.find(" " + method + " ") != std::string::npos)
        return line;
    return std::string();
  };
  EXPECT_THAT(turnedRow("ICP"), HasSubstr(" failed "));
  EXPECT_THAT(turnedRow("GICP"), HasSubstr(" inf "));
  EXPECT_THAT(turnedRow("NDT"), HasSubstr(" 0.0 % "));
  EXPECT_THAT(turnedRow("posture"), HasSubstr(" 50.0 % "));
}

TEST_F(Compare, withoutATruthItSaysThatNoneIsKnown) {
  const auto end = compare({folder_ / "flat.off", folder_ / "moved.off", "--method", "icp"});
  ASSERT_EQ(end.exit_code, 0) << end.err;
  EXPECT_THAT(end.out, HasSubstr("no truth is known"));
  EXPECT_THAT(end.out, Not(HasSubstr("the best method")));
  EXPECT_FALSE(result("pair.aligned.icp").contains("errors"));
  EXPECT_FALSE(fs::exists(out_ / "curves-aligned.svg"));
}

TEST_F(Compare, variationsMoveAndScaleAndShuffleTheSource) {
  ASSERT_EQ(compare({folder_ / "flat.off",
                     folder_ / "flat.off",
                     "--truth",
                     "identity",
                     "--method",
                     "as-given",
                     "--method",
                     "posture"})
                .exit_code,
            0);
  EXPECT_NEAR(result("pair.aligned.as-given")["mean_distance"], 0, 1e-6);
  EXPECT_NEAR(result("pair.aligned.as-given")["errors"]["mean_x100"], 0, 1e-6);
  EXPECT_GT(result("pair.turned.as-given")["mean_distance"], 0.1);
  EXPECT_GT(result("pair.scaled.as-given")["mean_distance"], 100);
  // Where it came from, and in what order, is nothing to a method that looks at the shape.
  const double aligned = result("pair.aligned.posture")["errors"]["mean_x100"];
  for (const char* variation : {"turned", "scaled"}) {
    const json other = result(std::string("pair.") + variation + ".posture");
    EXPECT_NEAR(other["errors"]["mean_x100"], aligned, 0.02 * aligned + 1e-3) << variation;
  }
}

TEST_F(Compare, namesTheFileThatCannotBeUsed) {
  const std::string latin = folder_ /
                            "fl\xE4"
                            "che.off";
  fs::copy_file(folder_ / "flat.off", latin);
  const test::ProgramRun not_utf8 = compare({latin, folder_ / "bent.off", "--method", "icp"});
  EXPECT_EQ(not_utf8.exit_code, 3);
  EXPECT_EQ(not_utf8.err, "posture: " + latin + ": a name that is not UTF-8\n");
  const std::string line = folder_ / "line.off", flat = folder_ / "flat.off";
  std::ofstream(line) << "OFF\n3 1 0\n0 0 0\n1 0 0\n2 0 0\n3 0 1 2\n";
  compare({flat, line, "--method", "posture", "--method", "icp", "--variation", "aligned"});
  EXPECT_EQ(result("pair.aligned.posture")["message"], line + ": has only faces without area");
  EXPECT_EQ(result("pair.aligned.icp")["message"],
            flat + " onto " + line + ": 3 points, expected 10 or more");
}

TEST_F(Compare, aListGivesARowAMethodAndVariation) {
  const auto end = comparePairs({"--variation", "aligned"});
  ASSERT_EQ(end.exit_code, 0) << end.err;
  EXPECT_EQ(std::count(end.err.begin(), end.err.end(), '\n'), 6) << end.err;  // a line a run
  EXPECT_EQ(result("missing.aligned.icp")["status"], "not run");
  EXPECT_THAT(result("missing.aligned.icp")["message"], HasSubstr("none.off"));
  const std::string page = test::bytesOf(out_ / "comparison.md");
  EXPECT_THAT(page, HasSubstr("| stiff |  soft |"));
  EXPECT_THAT(page, HasSubstr("of 2 pairs with a truth, the best method is "));
  EXPECT_LT(result("rigid.aligned.icp")["errors"]["mean_x100"],
            result("bent.aligned.icp")["errors"]["mean_x100"]);
}

TEST_F(Compare, resumesAndKeepsWhatIsNotAskedFor) {
  ASSERT_EQ(comparePairs({"--variation", "aligned", "--pair", "rigid"}).exit_code, 0);
  const auto before = result.written("rigid.aligned.icp");
  const auto again = comparePairs({"--variation", "aligned", "--variation", "turned"});
  ASSERT_EQ(again.exit_code, 0);
  EXPECT_EQ(std::count(again.err.begin(), again.err.end(), '\n'), 10) << again.err;
  EXPECT_EQ(result.written("rigid.aligned.icp"), before);

  ASSERT_EQ(comparePairs({"--variation", "turned", "--family", "stiff", "--fresh"}).exit_code, 0);
  EXPECT_EQ(result.written("rigid.aligned.icp"), before);
  EXPECT_EQ(parseCsv(test::bytesOf(out_ / "comparison.csv")).size(), 13u);

  std::ofstream(out_ / "runs/rigid.aligned.icp.json") << "{\"id\": \"ri";
  ASSERT_EQ(comparePairs({"--variation", "aligned"}).exit_code, 0);
  EXPECT_EQ(result("rigid.aligned.icp")["status"], "converged");
}

TEST_F(Compare, runsAgainWhatIsOfOtherFilesOrAnotherVersion) {
  const auto run = [this] {
    const auto end = comparePairs({"--variation", "aligned", "--pair", "rigid"});
    EXPECT_EQ(end.exit_code, 0) << end.err;
    return std::count(end.err.begin(), end.err.end(), '\n');
  };
  EXPECT_EQ(run(), 2);
  EXPECT_EQ(run(), 0);
  const double before = result("rigid.aligned.as-given")["mean_distance"];

  TriangleMesh moved = test::taperedStrip(0);
  moved.vertices.rowwise() += Eigen::RowVector3d(0.06, -0.04, 0.08);
  writeMesh(folder_ / "moved.off", moved);
  EXPECT_EQ(run(), 2);
  EXPECT_GT(result("rigid.aligned.as-given")["mean_distance"], 1.5 * before);

  json stored = result("rigid.aligned.icp");
  const json version = stored["version"];
  stored["version"] = "0.0.1";
  std::ofstream(out_ / "runs/rigid.aligned.icp.json") << stored;
  EXPECT_EQ(run(), 1);
  EXPECT_EQ(result("rigid.aligned.icp")["version"], version);

  std::ofstream(folder_ / "pairs.csv") << "id,family,kind,source,target,truth\n"
                                          "rigid,hard,rigid,flat.off,moved.off,identity\n";
  EXPECT_EQ(run(), 2);
  EXPECT_EQ(result("rigid.aligned.icp")["family"], "hard");
}

TEST_F(Compare, runsAsTheFirstProcessOfAContainer) {
  const std::vector<std::string> own_processes{"--user", "--map-root-user", "--pid", "--fork"};
  const auto asFirst = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), own_processes.begin(), own_processes.end());
    return test::run("/usr/bin/unshare", arguments);
  };
  if (asFirst({"/bin/true"}).exit_code != 0) GTEST_SKIP() << "namespaces are not allowed here";
  const auto end = asFirst({POSTURE,
                            "compare",
                            folder_ / "flat.off",
                            folder_ / "moved.off",
                            "--method",
                            "icp",
                            "--variation",
                            "aligned",
                            "-o",
                            out_});
  ASSERT_EQ(end.exit_code, 0) << end.err;
  EXPECT_EQ(result("pair.aligned.icp")["status"], "converged");
}

TEST_F(Compare, aRunWhoseParentHasEndedEnds) {
  const auto end =
      test::run(POSTURE, {"compare-run", "{}", folder_ / "result.json", "--parent", "1"});
  EXPECT_EQ(end.exit_code, 128 + SIGKILL) << end.err;
}

TEST_F(Compare, aRunThatTakesTooLongHasFailed) {
  const auto end = comparePairs(
      {"--quiet", "--pair", "rigid", "--variation", "aligned", "--time-limit", "0.001"});
  EXPECT_EQ(end.exit_code, 0);
  EXPECT_EQ(result("rigid.aligned.icp")["status"], "failed");
  EXPECT_THAT(result("rigid.aligned.icp")["message"], HasSubstr("took longer than"));
}

TEST_F(Compare, quietAndJson) {
  const auto quiet = comparePairs({"--quiet", "--pair", "rigid", "--variation", "aligned"});
  EXPECT_EQ(quiet.out + quiet.err, "");
  const auto as_json =
      comparePairs({"--quiet", "--json", "--pair", "rigid", "--variation", "aligned"});
  EXPECT_EQ(as_json.err, "");
  const json summary = json::parse(as_json.out);
  EXPECT_EQ(summary["runs"].size(), 2u);
  EXPECT_EQ(summary["verdicts"].size(), 1u);
}

TEST_F(Compare, saysWhatItCannotUse) {
  const auto missing = compare({folder_ / "none.off", folder_ / "bent.off"});
  EXPECT_EQ(missing.exit_code, 3);
  EXPECT_TRUE(test::saidWhyInOneLine(missing)) << missing.err;
  EXPECT_FALSE(fs::exists(out_ / "runs"));
  std::ofstream(folder_ / "latin.csv") << "id,source,target,note\na,flat.off,bent.off,K\xe4"
                                          "fer\n";
  const auto latin = compare({folder_ / "latin.csv"});
  EXPECT_EQ(latin.exit_code, 3);
  EXPECT_THAT(latin.err, HasSubstr("latin.csv: pair a"));
  const auto no_truth =
      compare({folder_ / "flat.off", folder_ / "bent.off", "--truth", folder_ / "none.txt"});
  EXPECT_EQ(no_truth.exit_code, 3);
  EXPECT_TRUE(test::saidWhyInOneLine(no_truth)) << no_truth.err;
  for (const std::vector<std::string>& wrong :
       {std::vector<std::string>{folder_ / "pairs.csv", "--truth", "identity"},
        {folder_ / "pairs.csv", "--family", "cat"},
        {folder_ / "flat.off", folder_ / "bent.off", "--pair", "bent"},
        {folder_ / "pairs.csv", "--method", "icq"},
        {folder_ / "pairs.csv", "--variation", "upside-down"}}) {
    const auto end = compare(wrong);
    EXPECT_EQ(end.exit_code, 2) << wrong.back();
    EXPECT_TRUE(test::saidWhyInOneLine(end)) << end.err;
  }
}

}  // namespace
}  // namespace posture
