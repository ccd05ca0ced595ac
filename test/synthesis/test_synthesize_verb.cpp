// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/io/correspondence_io.h>
#include <posture/io/mesh_io.h>
#include <posture/io/shape_io.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "apps/program.h"
#include "body_checks.h"
#include <map>
#include <set>
#include <sstream>
#include <string>

namespace posture {
namespace {

using namespace test;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

ProgramRun synthesize(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), "synthesize");
  return run(PROGRAM_DIR "/posture", arguments);
}

TEST(SynthesizeVerb, writesShapesTruthAndTheListOfPairs) {
  const TemporaryFolder folder;
  const std::string out = folder / "new/made";
  const ProgramRun ended = synthesize({"-o",
                                       out,
                                       "--kind",
                                       "human",
                                       "--pose",
                                       "0",
                                       "--pose",
                                       "3",
                                       "--vertices",
                                       "1500",
                                       "--quiet"});
  EXPECT_EQ(ended.exit_code, 0);
  EXPECT_EQ(ended.err, "");
  EXPECT_EQ(ended.out, "");
  const TriangleMesh source = readMesh(out + "/human-pose0.ply").mesh;
  const TriangleMesh target = readMesh(out + "/human-pose3.ply").mesh;
  EXPECT_TRUE(source.faces == target.faces);
  const auto truth = readVertexPairs(out + "/human-pose0-pose3.txt");
  ASSERT_EQ(static_cast<Eigen::Index>(truth.size()), source.vertices.rows());
  for (const VertexPair& pair : truth) ASSERT_EQ(pair.source, pair.target);
  EXPECT_GT(readVertexPairs(out + "/human-pose0-pose3-mirror.txt").size(), 1400u);
  EXPECT_EQ(bytesOf(out + "/pairs.csv"),
            "id,family,kind,source,target,truth,mirror_truth,note\n"
            "human-pose0-pose3,human,isometric,human-pose0.ply,human-pose3.ply,"
            "human-pose0-pose3.txt,human-pose0-pose3-mirror.txt,"
            "synthetic; tessellations 0 and 0\n");
}

TEST(SynthesizeVerb, writesTheBonesAndHowTheyMove) {
  const TemporaryFolder folder;
  const std::string out = folder / "made";
  ASSERT_EQ(synthesize({"-q", "-o", out, "--pose", "0", "3", "--vertices", "1500"}).exit_code, 0);
  const Points rest = readMesh(out + "/quadruped-pose0.ply").mesh.vertices,
               pose = readMesh(out + "/quadruped-pose3.ply").mesh.vertices;
  std::map<std::string, Eigen::Isometry3d> motion;
  const auto bones = nlohmann::json::parse(bytesOf(out + "/bones.json"));
  for (const auto& bone : bones["quadruped-pose3.ply"]) {
    Eigen::Isometry3d& of_bone = motion[bone["bone"]];
    for (int i = 0; i < 3; ++i) {
      of_bone.translation()[i] = bone["translation"][i];
      for (int j = 0; j < 3; ++j) of_bone.linear()(i, j) = bone["rotation"][i][j];
    }
  }
  std::istringstream rows(bytesOf(out + "/quadruped-pose0-bones.csv"));
  std::string row;
  std::getline(rows, row);
  EXPECT_EQ(row, "vertex,bone,weight");
  std::set<std::string> seen;
  int vertex = 0, rigid = 0;
  for (; std::getline(rows, row); ++vertex) {
    const auto first = row.find(','), second = row.rfind(',');
    ASSERT_EQ(std::stoi(row), vertex);
    const std::string bone = row.substr(first + 1, second - first - 1);
    ASSERT_EQ(motion.count(bone), 1u) << bone;
    seen.insert(bone);
    if (std::stod(row.substr(second + 1)) < 1) continue;
    ++rigid;
    const Eigen::Vector3d moved = motion[bone] * Eigen::Vector3d(rest.row(vertex));
    ASSERT_LT((moved - Eigen::Vector3d(pose.row(vertex))).norm(), 1e-5) << bone;
  }
  EXPECT_EQ(vertex, rest.rows());
  EXPECT_GT(4 * rigid, vertex);
  EXPECT_EQ(seen.size(), motion.size());
}

TEST(SynthesizeVerb, meshesAnewAndCutsHolesWhereAsked) {
  const TemporaryFolder folder;
  const std::string out = folder / "made";
  const ProgramRun ended = synthesize({"-o",
                                       out,
                                       "--pose",
                                       "0",
                                       "2",
                                       "--vertices",
                                       "1500",
                                       "--remesh",
                                       "--holes",
                                       "3",
                                       "--hole-radius",
                                       "0.03",
                                       "--noise",
                                       "0.0005",
                                       "--json"});
  EXPECT_EQ(ended.exit_code, 0);
  EXPECT_THAT(ended.out, HasSubstr("\"true_pairs\""));
  for (const char* name : {"/quadruped-pose0.ply", "/quadruped-pose2.ply"})
    EXPECT_EQ(topologyOf(readMesh(out + name).mesh).rims, 3) << name;
  EXPECT_THAT(bytesOf(out + "/pairs.csv"), HasSubstr(",noise,"));
  EXPECT_THAT(bytesOf(out + "/pairs.csv"), HasSubstr("tessellations 0 and 1"));
}

TEST(SynthesizeVerb, writesTheSameBytesForTheSameSeed) {
  const TemporaryFolder folder;
  const auto made = [&](const std::string& name, const std::string& seed) {
    synthesize(
        {"-o", folder / name, "--pose", "4", "--vertices", "1000", "--holes", "2", "--seed", seed});
    return bytesOf((folder / name) + "/quadruped-pose4.ply");
  };
  const std::string first = made("a", "7");
  EXPECT_GT(first.size(), 1000u);
  EXPECT_EQ(made("b", "7"), first);
  EXPECT_NE(made("c", "8"), first);
}

TEST(SynthesizeVerb, scansEachPose) {
  const TemporaryFolder folder;
  const auto scan = [&](const std::string& name, const std::string& threads) {
    return synthesize({"-o",
                       folder / name,
                       "--kind",
                       "human",
                       "--pose",
                       "0",
                       "3",
                       "--vertices",
                       "1500",
                       "--scan",
                       "--points",
                       "2000",
                       "--remesh",
                       "--json",
                       "--quiet",
                       "--threads",
                       threads});
  };
  const ProgramRun ended = scan("a", "1");
  EXPECT_EQ(ended.exit_code, 0);
  EXPECT_THAT(ended.out, HasSubstr("\"human-pose3-scan.pcd\""));
  const std::string out = folder / "a";
  const auto cloud = readShape(out + "/human-pose0-scan.pcd").cloud;
  const TriangleMesh surface = readMesh(out + "/human-pose0.ply").mesh;
  for (const VertexPair& place : readVertexPairs(out + "/human-pose0-scan-surface.txt")) {
    ASSERT_LT(place.source, cloud.points.rows());
    ASSERT_LT(place.target, surface.vertices.rows());
  }
  EXPECT_GT(readVertexPairs(out + "/human-pose0-pose3-scan.txt").size(), 1500u);
  EXPECT_GT(readVertexPairs(out + "/human-pose0-pose3-scan-mirror.txt").size(), 1500u);
  EXPECT_EQ(bytesOf(out + "/pairs.csv"),
            "id,family,kind,source,target,truth,mirror_truth,note,target_surface,"
            "target_surface_vertices\n"
            "human-pose0-pose3,human,isometric,human-pose0.ply,human-pose3.ply,"
            "human-pose0-pose3.txt,human-pose0-pose3-mirror.txt,"
            "synthetic; tessellations 0 and 1,,\n"
            "human-pose0-pose3-scan,human,scan,human-pose0-scan.pcd,human-pose3-scan.pcd,"
            "human-pose0-pose3-scan.txt,human-pose0-pose3-scan-mirror.txt,"
            "synthetic; tessellations 0 and 1,human-pose3.ply,human-pose3-scan-surface.txt\n");
  EXPECT_EQ(scan("b", "2").exit_code, 0);
  for (const char* file : {"/human-pose0-scan.pcd", "/human-pose3-scan.pcd", "/human-pose0.ply"})
    EXPECT_EQ(bytesOf((folder / "b") + file), bytesOf(out + file)) << file;
}

// Not byte by byte: the last bits of a sine, and with them a step of a depth, may differ elsewhere.
TEST(SynthesizeVerb, makesTheScansOfTheDataFolder) {
  const TemporaryFolder folder;
  const std::string made = folder / "scans", kept = DATA_DIR "/scans";
  const ProgramRun ended = synthesize({"-o",
                                       made,
                                       "--kind",
                                       "human",
                                       "--pose",
                                       "0",
                                       "6",
                                       "--vertices",
                                       "5000",
                                       "--remesh",
                                       "--scan",
                                       "--points",
                                       "15000",
                                       "--quiet"});
  ASSERT_EQ(ended.exit_code, 0);
  EXPECT_EQ(bytesOf(made + "/pairs.csv"), bytesOf(kept + "/pairs.csv"));
  for (const char* file : {"/human-pose0-scan.pcd", "/human-pose6-scan.pcd"}) {
    const Points a = readShape(made + file).cloud.points, b = readShape(kept + file).cloud.points;
    ASSERT_EQ(a.rows(), b.rows());
    const double size = (b.colwise().maxCoeff() - b.colwise().minCoeff()).maxCoeff();
    const auto differ = ((a - b).rowwise().norm().array() > 1e-5 * size).count();
    EXPECT_LT(static_cast<double>(differ), 0.001 * static_cast<double>(a.rows()));
  }
}

TEST(SynthesizeVerb, makesTheRigidPairOfTheDataFolder) {
  const TemporaryFolder folder;
  const std::string made = folder / "rigid", kept = DATA_DIR "/rigid";
  const ProgramRun ended =
      synthesize({"-o", made, "--rigid", "--vertices", "2500", "--noise", "0.003", "--quiet"});
  ASSERT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_EQ(folder.names(), std::vector<std::string>{"rigid"});
  for (const char* file : {"/pairs.csv", "/quadruped-rigid.txt", "/quadruped-rigid-mirror.txt"})
    EXPECT_EQ(bytesOf(made + file), bytesOf(kept + file)) << file;
  for (const char* file : {"/quadruped-rigid-source.ply", "/quadruped-rigid-target.ply"}) {
    const TriangleMesh a = readMesh(made + file).mesh, b = readMesh(kept + file).mesh;
    ASSERT_TRUE(a.faces == b.faces);
    // Kept in double precision, written in single: of a body about 1 long.
    EXPECT_LT((a.vertices - b.vertices).cwiseAbs().maxCoeff(), 1e-7);
  }
  EXPECT_EQ(synthesize({"-o", made, "--rigid", "--scan"}).exit_code, 2);
}

TEST(SynthesizeVerb, keepsTheGridOfASingleView) {
  const TemporaryFolder folder;
  EXPECT_EQ(synthesize({"-o",
                        folder / "a",
                        "--pose",
                        "0",
                        "--vertices",
                        "1500",
                        "--scan",
                        "--views",
                        "1",
                        "--points",
                        "2000",
                        "--scan-noise",
                        "0"})
                .exit_code,
            0);
  const PointCloud cloud = readShape((folder / "a") + "/quadruped-pose0-scan.pcd").cloud;
  EXPECT_GT(cloud.width, 50);
  EXPECT_TRUE(cloud.sensor);
}

TEST(SynthesizeVerb, writesNoPairsForOneShape) {
  const TemporaryFolder folder;
  EXPECT_EQ(synthesize({"-o", folder / ".", "--pose", "5", "--vertices", "1000"}).exit_code, 0);
  EXPECT_THAT(folder.names(),
              ElementsAre("bones.json", "quadruped-pose5-bones.csv", "quadruped-pose5.ply"));
}

TEST(SynthesizeVerb, leavesNothingOfAnotherRunBesideAShape) {
  const TemporaryFolder folder;
  const auto run = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {"-o", folder / ".", "--pose", "5", "--vertices", "1000"});
    EXPECT_EQ(synthesize(more).exit_code, 0);
    return folder.names();
  };
  const auto meshes = run({}), scans = run({"--scan", "--points", "1000"});
  EXPECT_THAT(
      scans,
      ElementsAre(
          "quadruped-pose5-scan-surface.txt", "quadruped-pose5-scan.pcd", "quadruped-pose5.ply"));
  EXPECT_EQ(run({}), meshes);
  // A link stays one, and is written through.
  std::filesystem::rename(folder / "quadruped-pose5.ply", folder / "elsewhere.ply");
  std::filesystem::create_symlink("elsewhere.ply", folder / "quadruped-pose5.ply");
  run({});
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "quadruped-pose5.ply"));
}

TEST(SynthesizeVerb, whatCannotBeMadeTakesNothingAway) {
  const TemporaryFolder folder;
  const std::vector<std::string> made{"-o", folder / ".", "--pose", "5", "6", "--vertices", "1000"};
  EXPECT_EQ(synthesize(made).exit_code, 0);
  const auto before = folder.names();
  std::vector<std::string> refused = made;
  refused.insert(refused.end(), {"--holes", "900"});
  EXPECT_NE(synthesize(refused).exit_code, 0);
  EXPECT_EQ(folder.names(), before);
}

TEST(SynthesizeVerb, refusesWhatCannotBeMeant) {
  const TemporaryFolder folder;
  const std::vector<std::vector<std::string>> wrong = {{"--kind", "fish"},
                                                       {"--pose", "1", "1"},
                                                       {"--pose", "-1"},
                                                       {"--vertices", "10"},
                                                       {"--tessellation", "1", "2", "3"},
                                                       {"--tessellation", "1", "2", "--remesh"},
                                                       {"--holes", "-1"},
                                                       {"--holes", "900", "--vertices", "1000"},
                                                       {"--noise", "nan"},
                                                       {"--views", "2"},
                                                       {"--scan", "--views", "0"},
                                                       {"--scan", "--noise", "0.1"},
                                                       {"--scan", "--points", "10"},
                                                       {"--scan", "--scan-noise", "-1"},
                                                       {"--unknown"}};
  for (std::vector<std::string> arguments : wrong) {
    const std::string last = arguments.back();
    arguments.insert(arguments.end(), {"-o", folder / "made"});
    const ProgramRun ended = synthesize(arguments);
    EXPECT_EQ(ended.exit_code, 2) << last;
    EXPECT_TRUE(saidWhyInOneLine(ended)) << last << ": " << ended.err;
  }
  EXPECT_EQ(synthesize({"--pose", "1"}).exit_code, 2);
}

TEST(SynthesizeVerb, saysWhereItCannotWrite) {
  const ProgramRun ended = synthesize({"-o", "/proc/nowhere", "--vertices", "1000"});
  EXPECT_EQ(ended.exit_code, 3);
  EXPECT_TRUE(saidWhyInOneLine(ended));
  EXPECT_THAT(ended.err, HasSubstr("/proc/nowhere"));
}

}  // namespace
}  // namespace posture
