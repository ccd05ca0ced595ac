// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/io/mesh_io.h>
#include <posture/io/shape_io.h>
#include <posture/mesh/half_edge_mesh.h>
#include <posture/synthesis/articulated_body.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "apps/program.h"
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>

namespace posture {
namespace {

using nlohmann::json;
using testing::HasSubstr;

const std::string POSTURE = std::string(PROGRAM_DIR) + "/posture";

class Reconstruct : public testing::Test {
 protected:
  Reconstruct() {
    BodyOptions options;
    options.vertices = 4000;
    cloud_.points = makeBody(options).mesh.vertices;
    write("body.xyz", 1);
  }

  void write(const std::string& name, double unit) const {
    PointCloud cloud = cloud_;
    cloud.points *= unit;
    writePointCloud(folder_ / name, cloud);
  }

  template <class Line>
  void writeLines(const std::string& name, int count, const Line& line) const {
    std::ofstream out(folder_ / name);
    for (int i = 0; i < count; ++i) out << line(i) << '\n';
  }

  test::ProgramRun reconstruct(const std::string& scan, std::vector<std::string> more = {}) const {
    more.insert(more.begin(), {"reconstruct", folder_ / scan, "-o", folder_ / "mesh.ply"});
    return test::run(POSTURE, more);
  }

  const test::TemporaryFolder folder_;
  PointCloud cloud_;
};

TEST_F(Reconstruct, laysAManifoldThroughThePointsAndLinksThem) {
  const auto end = reconstruct("body.xyz", {"--link", folder_ / "link.csv", "--json"});
  ASSERT_EQ(end.exit_code, 0) << end.err;
  const TriangleMesh mesh = readMesh(folder_ / "mesh.ply").mesh;
  const json summary = json::parse(end.out);
  EXPECT_EQ(summary["points"], cloud_.points.rows());
  EXPECT_EQ(summary["faces"], mesh.faces.rows());
  EXPECT_NO_THROW(HalfEdgeMesh(mesh.faces, static_cast<int>(mesh.vertices.rows())));
  std::ifstream link(folder_ / "link.csv");
  const std::string rows((std::istreambuf_iterator<char>(link)), {});
  EXPECT_EQ(std::count(rows.begin(), rows.end(), '\n'), cloud_.points.rows() + 1);
}

TEST_F(Reconstruct, worksInAnyUnit) {
  write("micro.ply", 1e-6);
  write("kilo.ply", 1e6);
  const auto facesOf = [&](const std::string& scan) {
    const auto end = reconstruct(scan, {"--json"});
    EXPECT_EQ(end.exit_code, 0) << end.err;
    return json::parse(end.out)["faces"].get<double>();
  };
  const double faces = facesOf("body.xyz");
  EXPECT_NEAR(facesOf("micro.ply"), faces, 0.01 * faces);
  EXPECT_NEAR(facesOf("kilo.ply"), faces, 0.01 * faces);
}

TEST_F(Reconstruct, offersTheSurfacesOfPcl) {
  for (const std::string method : {"mls", "poisson", "greedy"}) {
    const auto end = reconstruct("body.xyz", {"--surface", method, "--json"});
    ASSERT_EQ(end.exit_code, 0) << method << ": " << end.err;
    EXPECT_GT(json::parse(end.out)["faces"].get<int>(), 2000) << method;
  }
  EXPECT_EQ(reconstruct("body.xyz", {"--surface", "magic"}).exit_code, 2);
}

TEST_F(Reconstruct, refusesAnEndingBeforeTheWork) {
  const auto end =
      test::run(POSTURE, {"reconstruct", folder_ / "none.xyz", "-o", folder_ / "mesh.stl"});
  EXPECT_EQ(end.exit_code, 2);
  EXPECT_TRUE(test::saidWhyInOneLine(end)) << end.err;
  EXPECT_THAT(end.err, HasSubstr(".off"));
}

TEST_F(Reconstruct, doesNotWriteOverTheScan) {
  write("scan.ply", 1);
  const std::string before = test::bytesOf(folder_ / "scan.ply");
  for (const std::vector<std::string>& outputs :
       {std::vector<std::string>{"-o", folder_ / "scan.ply"},
        std::vector<std::string>{"-o", folder_ / "other.ply", "--link", folder_ / "scan.ply"}}) {
    std::vector<std::string> arguments{"reconstruct", folder_ / "scan.ply"};
    arguments.insert(arguments.end(), outputs.begin(), outputs.end());
    const auto end = test::run(POSTURE, arguments);
    EXPECT_EQ(end.exit_code, 3);
    EXPECT_THAT(end.err, HasSubstr("written over"));
    EXPECT_EQ(test::bytesOf(folder_ / "scan.ply"), before);
  }
}

TEST_F(Reconstruct, saysWhetherThePointsAreTheVertices) {
  const auto end = reconstruct("body.xyz", {"--json"});
  EXPECT_EQ(json::parse(end.out).at("through_points"), true);
  EXPECT_THAT(reconstruct("body.xyz").out, HasSubstr("are its vertices"));
  EXPECT_EQ(
      json::parse(reconstruct("body.xyz", {"--surface", "mls", "--json"}).out).at("through_points"),
      false);
}

TEST_F(Reconstruct, badInputIsOneLineAndLeavesNothing) {
  writeLines("empty.xyz", 0, [](int) { return ""; });
  writeLines("equal.xyz", 100, [](int) { return "1 2 3"; });
  writeLines("line.xyz", 100, [](int i) { return std::to_string(i) + " 0 0"; });
  writeLines("two.xyz", 2, [](int i) { return std::to_string(i) + " 0 0"; });
  writeLines("nan.xyz", 50, [](int) { return "nan nan nan"; });
  writeLines("inf.xyz", 50, [](int i) { return "inf 0 " + std::to_string(i); });
  writeMesh(folder_ / "faces.ply", {Points::Random(3, 3), Eigen::RowVector3i(0, 1, 2)});
  for (const std::string scan : {"empty.xyz",
                                 "equal.xyz",
                                 "line.xyz",
                                 "two.xyz",
                                 "nan.xyz",
                                 "inf.xyz",
                                 "faces.ply",
                                 "none.xyz"}) {
    const auto end = reconstruct(scan);
    EXPECT_EQ(end.exit_code, 3) << scan;
    EXPECT_TRUE(test::saidWhyInOneLine(end)) << scan << ": " << end.err;
    EXPECT_THAT(end.err, HasSubstr(scan));
    EXPECT_FALSE(std::filesystem::exists(folder_ / "mesh.ply")) << scan;
    const auto registration = test::run(
        POSTURE, {"register", folder_ / scan, folder_ / "body.xyz", "-o", folder_ / "out"});
    if (scan == "faces.ply") continue;  // a mesh is no bad input there
    EXPECT_EQ(registration.exit_code, 3) << scan;
    EXPECT_THAT(registration.err, HasSubstr(scan));
  }
}

TEST_F(Reconstruct, aPlaneIsAnOpenSurface) {
  writeLines("plane.xyz", 900, [](int i) {
    return std::to_string(i % 30) + " " + std::to_string(i / 30) + " 0";
  });
  const auto end = reconstruct("plane.xyz", {"--json"});
  ASSERT_EQ(end.exit_code, 0) << end.err;
  EXPECT_EQ(json::parse(end.out)["boundary_loops"], 1);
}

}  // namespace
}  // namespace posture
