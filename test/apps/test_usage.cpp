// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/io/mesh_io.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "apps/program.h"
#include "support/shapes.h"
#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

namespace posture {
namespace {

using test::ProgramRun;
using test::TemporaryFolder;
using testing::HasSubstr;

const std::string POSTURE = std::string(PROGRAM_DIR) + "/posture";

using Arguments = std::vector<std::string>;

void expectRefused(int exit_code, const Arguments& arguments, const std::string& said) {
  const ProgramRun ended = test::run(POSTURE, arguments);
  EXPECT_EQ(ended.exit_code, exit_code) << said;
  EXPECT_TRUE(test::saidWhyInOneLine(ended)) << ended.out << ended.err;
  EXPECT_THAT(ended.err, HasSubstr(said));
}

void expectWrongUsage(const Arguments& arguments, const std::string& said) {
  expectRefused(2, arguments, said);
}

TEST(Usage, namesTheVerbThatIsNone) {
  expectWrongUsage({}, "a verb is missing (see posture --help)");
  expectWrongUsage({"--quiet"}, "a verb is missing");
  expectWrongUsage({"regster", "a", "b"}, "'regster' is neither a verb nor an option");
  expectWrongUsage({"--loud"}, "'--loud' is neither a verb nor an option");
  expectWrongUsage({"register", "a"}, "TARGET is required (see posture register --help)");
}

TEST(Usage, anEmptyArgumentIsNoName) {
  expectWrongUsage({"register", "a", "b", "-o", ""}, "the argument behind '-o' is empty");
  expectWrongUsage({"register", "", "b", "-o", "c"}, "the argument behind 'register' is empty");
  expectWrongUsage({"register", "a", "b", "-o", "c", "--dump", ""}, "behind '--dump' is empty");
}

TEST(Usage, numbersAreWholeOnesInTheirRangeAndNoneIsNan) {
  const std::string threads = " is no whole number from 1 to 1024";
  for (const std::string wrong : {"0", "-1", "1.5", "1025", "x", "0x1", "010", "1e1", "nan"})
    expectWrongUsage({"register", "a", "b", "-o", "c", "--threads", wrong},
                     "--threads: " + wrong + threads);
  for (const std::string wrong : {"-1", "x", "1e3", "18446744073709551616"})
    expectWrongUsage({"synthesize", "-o", "c", "--seed", wrong},
                     "--seed: " + wrong + " is no whole number from 0 to 18446744073709551615");
  for (const std::string wrong : {"0", "-3", "nan", "inf", "x"})
    for (const std::string verb : {"benchmark", "compare"})
      expectWrongUsage({verb, "list.csv", "-o", "c", "--time-limit", wrong},
                       "--time-limit: " + wrong + " is no number from 0.001 to 1000000");
  for (const std::string option : {"--noise", "--hole-radius"})
    expectWrongUsage({"synthesize", "-o", "c", option, "nan"},
                     option + ": nan is no number from 0 to 1");
}

TEST(Usage, surfacesHaveNames) {
  for (const std::string wrong : {"ball", "3"})  // nor are they numbers
    expectWrongUsage({"reconstruct", "a.xyz", "-o", "b.ply", "--surface", wrong},
                     "--surface: " + wrong + " not in {delaunay,greedy,mls,poisson}");
}

TEST(Usage, optionsThatContradictEachOtherAreRefused) {
  expectWrongUsage({"register", "a", "b", "-o", "c", "--paper", "--both"}, "excludes --both");
  expectWrongUsage({"synthesize", "-o", "c", "--rigid", "--remesh"}, "--rigid");
  expectWrongUsage({"synthesize", "-o", "c", "--rigid", "--tessellation", "0", "1"},
                   "--rigid: takes one --tessellation");
  expectWrongUsage({"compare", "a", "b", "-o", "c", "--mirror", "d"}, "requires --truth");
  expectWrongUsage({"reconstruct", "a.xyz", "-o", "b.ply", "--link", "./b.ply"},
                   "--link: is the file of --output");
}

TEST(Usage, listsThatAreNoneAreNamed) {
  const TemporaryFolder folder;
  const auto at = [&](const std::string& name) -> std::string { return folder / name; };
  std::ofstream(at("empty.csv"));
  std::ofstream(at("header.csv")) << "id,source,target\n";
  writeMesh(at("ball.ply"), test::sphere(1));
  for (const std::string verb : {"benchmark", "compare"}) {
    const auto expectNamed = [&](const std::string& list, const std::string& said) {
      expectRefused(3, {verb, at(list), "-o", at("out")}, at(list) + ": " + said);
    };
    expectNamed("none.csv", "no such file");
    expectNamed(".", "is a folder, not a file");
    expectNamed("empty.csv", "the file is empty");
    expectNamed("header.csv", "lists no pair");
  }
  expectRefused(
      3, {"compare", at("ball.ply"), "-o", at("out")}, "without TARGET it has to be a list");
}

TEST(Usage, whatCannotBeWrittenIsFoundBeforeTheWork) {
  const TemporaryFolder folder;
  const std::string list = folder / "list.csv";
  std::ofstream(list) << "id,source,target\na,a.ply,b.ply\n";
  for (const auto& [verb, table] :
       {std::pair("benchmark", "RESULTS.md"), std::pair("compare", "comparison.md")}) {
    const std::string out = folder / verb;
    std::filesystem::create_directories(out + "/" + table);
    expectRefused(3, {verb, list, "-o", out}, out + "/" + table + ": cannot be written");
  }
}

TEST(Usage, synthesizeLeavesNoListOfOtherMeshes) {
  const TemporaryFolder folder;
  const std::string out = folder / "out";
  const auto synthesize = [&](std::vector<std::string> poses) {
    poses.insert(poses.begin(), {"synthesize", "-q", "--vertices", "1000", "-o", out, "--pose"});
    return test::run(POSTURE, poses).exit_code;
  };
  ASSERT_EQ(synthesize({"0", "1"}), 0);
  EXPECT_TRUE(std::filesystem::exists(out + "/pairs.csv"));
  ASSERT_EQ(synthesize({"0"}), 0);
  EXPECT_FALSE(std::filesystem::exists(out + "/pairs.csv"));
}

TEST(Usage, whatCannotBePrintedIsAnError) {
  const TemporaryFolder folder;
  const std::string command =
      POSTURE + " synthesize -q --json --vertices 1000 -o " + std::string(folder / "out");
  const ProgramRun ended = test::run("/bin/sh", {"-c", command + " > /dev/full"});
  EXPECT_EQ(ended.exit_code, 3);
  EXPECT_TRUE(test::saidWhyInOneLine(ended)) << ended.err;
  EXPECT_THAT(ended.err, HasSubstr("stdout"));
}

}  // namespace
}  // namespace posture
