// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/io/mesh_io.h>
#include <posture/io/shape_io.h>

#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "apps/program.h"
#include "support/bodies.h"
#include "support/shapes.h"
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <memory>
#include <set>
#include <sstream>

namespace posture {
namespace {

using nlohmann::json;
using test::ProgramRun;
using test::TemporaryFolder;
using testing::HasSubstr;

namespace fs = std::filesystem;

const std::string POSTURE = std::string(PROGRAM_DIR) + "/posture";

const ArticulatedBody& body(int pose, int vertices = 1000) { return test::body(pose, vertices); }

std::vector<int> readParts(const fs::path& path) {
  std::istringstream rows(test::bytesOf(path));
  std::string row;
  std::getline(rows, row);
  EXPECT_EQ(row, "vertex,part");
  std::vector<int> parts;
  while (std::getline(rows, row)) {
    EXPECT_EQ(row.substr(0, row.find(',')), std::to_string(parts.size()));
    parts.push_back(std::stoi(row.substr(row.find(',') + 1)));
  }
  return parts;
}

/// A body divided by one other pose, and again as a cloud.
class Segment : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = std::make_unique<TemporaryFolder>();
    writeMesh(at("rest.ply"), body(0).mesh);
    writeMesh(at("pose.off"), body(2).mesh);
    // What a run of more poses left that was killed before it wrote segments.json.
    fs::create_directory(at("mesh"));
    std::ofstream(at("mesh") + "/pose-2_segments.ply") << "ply\n";
    for (const char* mine : {"/notes.txt", "/pose-2.ply", "/pose-x_segments.ply"})
      std::ofstream(at("mesh") + mine) << "mine\n";
    of_mesh_ =
        test::run(POSTURE, {"segment", at("rest.ply"), at("pose.off"), "-o", at("mesh"), "--json"});
  }
  static void TearDownTestSuite() { folder_.reset(); }
  void SetUp() override { ASSERT_EQ(of_mesh_.exit_code, 0) << of_mesh_.err; }

  static std::string at(const std::string& name) { return *folder_ / name; }

  static inline std::unique_ptr<TemporaryFolder> folder_;
  static inline ProgramRun of_mesh_;
};

TEST_F(Segment, givesEveryVertexAPartAndEveryPartItsMotion) {
  const TriangleMesh rest = readMesh(at("rest.ply")).mesh;
  const std::vector<int> parts = readParts(at("mesh") + "/segments.csv");
  ASSERT_EQ(parts.size(), rest.vertices.rows());
  const json said = json::parse(test::bytesOf(at("mesh") + "/segments.json"));
  EXPECT_EQ(of_mesh_.out, test::bytesOf(at("mesh") + "/segments.json"));
  const int count = said.at("count");
  EXPECT_GT(count, 3);
  EXPECT_EQ(std::set<int>(parts.begin(), parts.end()).size(), count);
  ASSERT_EQ(said.at("poses").size(), 1u);
  ASSERT_EQ(said.at("poses")[0].at("motions").size(), count);
  EXPECT_EQ(said.at("left_out").size(), 0u);
}

TEST_F(Segment, leavesNothingOfAnEarlierResult) {
  EXPECT_FALSE(fs::exists(at("mesh") + "/pose-2_segments.ply"));
  EXPECT_TRUE(fs::exists(at("mesh") + "/pose-1_segments.ply"));
  for (const char* mine : {"/notes.txt", "/pose-2.ply", "/pose-x_segments.ply"})
    EXPECT_TRUE(fs::exists(at("mesh") + mine)) << mine;
}

TEST_F(Segment, itsMotionsTakeThePartsToThePose) {
  // Both bodies are numbered alike: the true place of a vertex is its own in the pose.
  const Points rest = body(0).mesh.vertices, pose = body(2).mesh.vertices;
  const std::vector<int> parts = readParts(at("mesh") + "/segments.csv");
  const json said = json::parse(test::bytesOf(at("mesh") + "/segments.json")).at("poses")[0];
  std::map<int, std::pair<double, int>> off;
  for (std::size_t v = 0; v < parts.size(); ++v) {
    if (parts[v] < 0) continue;
    const json& motion = said.at("motions")[parts[v]];
    Eigen::Matrix3d turn;
    Eigen::Vector3d move;
    for (int i = 0; i < 3; ++i) {
      move[i] = motion.at("translation")[i];
      for (int j = 0; j < 3; ++j) turn(i, j) = motion.at("rotation")[i][j];
    }
    EXPECT_NEAR(turn.determinant(), 1, 1e-9);
    const json& q = motion.at("quaternion_wxyz");
    EXPECT_TRUE(Eigen::Quaterniond(q[0], q[1], q[2], q[3]).toRotationMatrix().isApprox(turn, 1e-9));
    const Eigen::Vector3d moved =
        turn * (said.at("scale").get<double>() * rest.row(v).transpose()) + move;
    auto& [sum, count] = off[parts[v]];
    sum += (moved - pose.row(v).transpose()).norm();
    ++count;
  }
  // Of a body of about 1; at rest most of it is off by more than a tenth.
  EXPECT_LT(off[0].first / off[0].second, 0.05);
}

TEST_F(Segment, coloursPartsOnBothBodies) {
  const std::vector<int> parts = readParts(at("mesh") + "/segments.csv");
  const MeshFile colored = readMesh(at("mesh") + "/segments.ply");
  const Points in_single = body(0).mesh.vertices.cast<float>().cast<double>();
  EXPECT_EQ(colored.mesh.vertices, in_single);
  std::map<int, Eigen::Matrix<std::uint8_t, 1, 3>> color;
  for (std::size_t v = 0; v < parts.size(); ++v) color[parts[v]] = colored.colors.row(v);
  for (std::size_t v = 0; v < parts.size(); ++v) EXPECT_EQ(colored.colors.row(v), color[parts[v]]);
  for (Eigen::Index f = 0; f < colored.mesh.faces.rows(); ++f)
    for (int k = 0; k < 3; ++k) {
      const int a = parts[colored.mesh.faces(f, k)], b = parts[colored.mesh.faces(f, (k + 1) % 3)];
      if (a != b) {
        EXPECT_NE(color[a], color[b]);
      }
    }
  const MeshFile pose = readMesh(at("mesh") + "/pose-1_segments.ply");
  EXPECT_EQ(pose.mesh.faces, body(2).mesh.faces);
  ASSERT_EQ(pose.colors.rows(), pose.mesh.vertices.rows());
  int same = 0;
  for (std::size_t v = 0; v < parts.size(); ++v) same += pose.colors.row(v) == color[parts[v]];
  EXPECT_GT(same, static_cast<int>(parts.size()) / 2);
}

TEST_F(Segment, leavesOutWhatIsNotTheSameBody) {
  writeMesh(at("ball.ply"), test::sphere(3));
  // A result of `register`, whose segments.ply is not of an earlier `segment`.
  fs::create_directory(at("none"));
  for (const char* file : {"none/report.json", "none/segments.ply"})
    std::ofstream(at(file)) << "of register\n";
  const ProgramRun ended =
      test::run(POSTURE, {"segment", at("rest.ply"), at("ball.ply"), "-o", at("none"), "--json"});
  EXPECT_EQ(ended.exit_code, 1);
  EXPECT_THAT(ended.err, HasSubstr("ball.ply"));
  EXPECT_EQ(std::count(ended.err.begin(), ended.err.end(), '\n'), 1) << ended.err;
  const json said = json::parse(ended.out);
  EXPECT_EQ(said.at("count"), 0);
  EXPECT_EQ(said.at("left_out")[0].at("file"), at("ball.ply"));
  for (const char* file : {"none/report.json", "none/segments.ply"})
    EXPECT_EQ(test::bytesOf(at(file)), "of register\n") << file;
  EXPECT_EQ(std::distance(fs::directory_iterator(at("none")), {}), 2) << "nothing is written";
}

TEST_F(Segment, labelsThePointsOfACloud) {
  constexpr int ENOUGH = 2500;  // for a surface through the points alone
  PointCloud cloud;
  cloud.points = body(0, ENOUGH).mesh.vertices;
  cloud.points.conservativeResize(cloud.points.rows() + 1, 3);
  cloud.points.bottomRows(1).setConstant(std::nan(""));
  writePointCloud(at("cloud.pcd"), cloud);
  writeMesh(at("fine.ply"), body(2, ENOUGH).mesh);
  const ProgramRun ended =
      test::run(POSTURE, {"segment", at("cloud.pcd"), at("fine.ply"), "-o", at("cloud"), "-q"});
  ASSERT_EQ(ended.exit_code, 0) << ended.err;
  const std::vector<int> parts = readParts(at("cloud") + "/segments.csv");
  ASSERT_EQ(parts.size(), cloud.points.rows());
  EXPECT_EQ(parts.back(), -1);
  EXPECT_GT(std::set<int>(parts.begin(), parts.end()).size(), 4u);
  EXPECT_EQ(readShape(at("cloud") + "/segments.ply").cloud.colors.rows(), cloud.points.rows());
}

TEST(SegmentFails, whereItsResultsWouldTakeAnInputsPlace) {
  const TemporaryFolder folder;
  const auto expectKept =
      [&](const std::string& input, const std::string& ref, const std::string& pose) {
        const std::string before = test::bytesOf(input);
        const ProgramRun ended = test::run(POSTURE, {"segment", ref, pose, "-o", folder.path()});
        EXPECT_EQ(ended.exit_code, 3);
        EXPECT_TRUE(test::saidWhyInOneLine(ended)) << ended.out << ended.err;
        EXPECT_THAT(ended.err, HasSubstr(input + ": would be written over"));
        EXPECT_EQ(test::bytesOf(input), before);
      };
  const std::string rest = folder / "segments.ply", pose = folder / "pose-1_segments.ply",
                    sound = folder / "body.ply";
  writeMesh(sound, body(0).mesh);
  writeMesh(rest, body(0).mesh);
  expectKept(rest, rest, sound);
  fs::remove(rest);
  writeMesh(pose, body(2).mesh);
  expectKept(pose, sound, pose);
}

TEST(SegmentFails, onWrongUsageAndMissingFiles) {
  const TemporaryFolder folder;
  EXPECT_EQ(test::run(POSTURE, {"segment", "a.ply", "-o", folder / "out"}).exit_code, 2);
  EXPECT_EQ(test::run(POSTURE, {"segment", "a.ply", "b.ply", "-o", folder / "out"}).exit_code, 3);
}

}  // namespace
}  // namespace posture
