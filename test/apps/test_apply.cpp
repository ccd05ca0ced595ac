// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/io/mesh_io.h>
#include <posture/io/shape_io.h>
#include <posture/mesh/edges.h>
#include <posture/mesh/normals.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "apps/program.h"
#include "support/bodies.h"
#include "support/shapes.h"
#include <filesystem>
#include <fstream>
#include <memory>

namespace posture {
namespace {

using test::ProgramRun;
using test::TemporaryFolder;
using testing::HasSubstr;

namespace fs = std::filesystem;

const std::string POSTURE = std::string(PROGRAM_DIR) + "/posture";

const ArticulatedBody& body(int pose) { return test::body(pose, 1000); }

/// Results of register for a mesh, for the same body as a cloud, and for a noisy mesh of it.
class Apply : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = std::make_unique<TemporaryFolder>();
    const TriangleMesh source = body(0).mesh;
    writeMesh(at("source.ply"), source);
    writeMesh(at("target.ply"), body(2).mesh);
    writeCloud("cloud.xyz", source.vertices);
    TriangleMesh noisy = source;
    noisy.vertices += 0.4 * meanEdgeLength(source) * test::randomPoints(noisy.vertices.rows(), 3);
    writeMesh(at("noisy.ply"), noisy);
    for (const std::string name : {"source.ply", "cloud.xyz", "noisy.ply"}) {
      const ProgramRun ended = test::run(
          POSTURE, {"register", at(name), at("target.ply"), "-o", at("of-" + name), "-q"});
      ASSERT_EQ(ended.exit_code, 0) << ended.err;
    }
  }
  static void TearDownTestSuite() { folder_.reset(); }

  static std::string at(const std::string& name) { return *folder_ / name; }

  static void writeCloud(const std::string& name, const Points& points) {
    PointCloud cloud;
    cloud.points = points;
    writePointCloud(at(name), cloud);
  }

  static ProgramRun apply(const std::string& folder,
                          const std::string& points,
                          const std::string& output) {
    return test::run(POSTURE, {"apply", at(folder), at(points), "-o", at(output)});
  }

  static inline std::unique_ptr<TemporaryFolder> folder_;
};

TEST_F(Apply, takesTheSourceWhereRegisterTookIt) {
  const ProgramRun ended = apply("of-source.ply", "source.ply", "moved.ply");
  ASSERT_EQ(ended.exit_code, 0) << ended.err;
  const MeshFile moved = readMesh(at("moved.ply")),
                 registered = readMesh(at("of-source.ply") + "/registered.ply");
  EXPECT_EQ(moved.mesh.faces, registered.mesh.faces);
  EXPECT_EQ(moved.mesh.vertices, registered.mesh.vertices);
}

TEST_F(Apply, takesANoisySourceFromWhereRegisterHadIt) {
  const fs::path folder = at("of-noisy.ply");
  EXPECT_FALSE(fs::exists(fs::path(at("of-source.ply")) / "source_surface.ply"));
  TriangleMesh rest = readMesh(folder / "source_surface.ply").mesh;
  const TriangleMesh registered = readMesh(folder / "registered.ply").mesh;
  EXPECT_NE(rest.vertices, readMesh(at("noisy.ply")).mesh.vertices);
  const auto movesRest = [&](const std::string& result) {
    writeMesh(at("rest.ply"), rest);
    const ProgramRun ended = apply(result, "rest.ply", "rest-moved.ply");
    EXPECT_EQ(ended.exit_code, 0) << ended.err;
    EXPECT_EQ(readMesh(at("rest-moved.ply")).mesh.vertices, registered.vertices);
  };
  movesRest("of-noisy.ply");

  // The one that is stored, wherever it is: it is not computed again.
  fs::copy(folder, at("elsewhere"));
  rest.vertices.rowwise() += Eigen::RowVector3d(7, 8, 9);
  writeMesh(fs::path(at("elsewhere")) / "source_surface.ply", rest);
  movesRest("elsewhere");

  fs::remove(fs::path(at("elsewhere")) / "source_surface.ply");
  const ProgramRun ended = apply("elsewhere", "rest.ply", "never.ply");
  EXPECT_EQ(ended.exit_code, 3);
  EXPECT_THAT(ended.err, HasSubstr("source_surface.ply"));
}

TEST_F(Apply, takesThePointsOfACloudWhereRegisterTookThem) {
  const ProgramRun ended = apply("of-cloud.xyz", "cloud.xyz", "moved.xyz");
  ASSERT_EQ(ended.exit_code, 0) << ended.err;
  const Points moved = readShape(at("moved.xyz")).cloud.points,
               registered = readShape(at("of-cloud.xyz") + "/registered.ply").cloud.points;
  ASSERT_EQ(moved.rows(), registered.rows());
  EXPECT_LT((moved - registered).rowwise().norm().maxCoeff(), 1e-6);
}

TEST_F(Apply, keepsMarkersAboveTheirPlaceOnTheSurface) {
  const TriangleMesh source = body(0).mesh;
  const TriangleMesh registered = readMesh(at("of-source.ply") + "/registered.ply").mesh;
  const double height = 0.002;  // of a body of about 1
  writeCloud("markers.xyz", source.vertices + height * vertexNormals(source));
  const ProgramRun ended = apply("of-source.ply", "markers.xyz", "markers-moved.xyz");
  ASSERT_EQ(ended.exit_code, 0) << ended.err;
  const Points moved = readShape(at("markers-moved.xyz")).cloud.points;
  ASSERT_EQ(moved.rows(), source.vertices.rows());
  const Points expected = registered.vertices + height * vertexNormals(registered);
  EXPECT_LT((moved - expected).rowwise().norm().mean(), height / 2);
}

TEST_F(Apply, joinsFacetsThatShareNoVertices) {
  fs::create_directory(at("soup"));
  for (const char* name : {"source_colored.ply", "registered.ply"}) {
    const TriangleMesh whole = readMesh(at("of-source.ply") + "/" + name).mesh;
    writeMesh(at("soup") + "/" + name, test::soup(whole));
  }
  fs::copy(at("of-source.ply") + "/report.json", at("soup"));
  writeCloud("near.xyz", body(0).mesh.vertices.array() + 0.003);
  ASSERT_EQ(apply("soup", "near.xyz", "by-soup.xyz").exit_code, 0);
  ASSERT_EQ(apply("of-source.ply", "near.xyz", "by-mesh.xyz").exit_code, 0);
  const Points soup = readShape(at("by-soup.xyz")).cloud.points,
               mesh = readShape(at("by-mesh.xyz")).cloud.points;
  EXPECT_LT((soup - mesh).cwiseAbs().maxCoeff(), 1e-9);
}

TEST_F(Apply, passesOnWhatRegisterDoubted) {
  const auto withReport = [&](const std::string& name, const std::string& report) {
    fs::copy(at("of-source.ply"), at(name));
    std::ofstream(at(name) + "/report.json") << report;
    return apply(name, "source.ply", name + "-moved.ply");
  };
  const ProgramRun doubted = withReport(
      "doubted", R"({"status": "undecided", "message": "no idea", "chosen": 0, "files": {}})");
  EXPECT_EQ(doubted.exit_code, 1);
  EXPECT_THAT(doubted.err, HasSubstr("no idea"));
  EXPECT_TRUE(fs::exists(at("doubted-moved.ply")));
  const ProgramRun without = withReport(
      "without", R"({"status": "undecided", "message": "no map", "chosen": null, "files": {}})");
  EXPECT_EQ(without.exit_code, 3);
  EXPECT_TRUE(test::saidWhyInOneLine(without)) << without.err;
  EXPECT_THAT(without.err, HasSubstr("no map"));
  EXPECT_FALSE(fs::exists(at("without-moved.ply")));
}

TEST_F(Apply, refusesAnEndingThatDoesNotFit) {
  for (const std::string wrong : {"moved.stl", "moved.xyz"}) {  // a mesh is none of points
    const ProgramRun ended = apply("of-source.ply", "source.ply", wrong);
    EXPECT_EQ(ended.exit_code, 2) << wrong;
    EXPECT_TRUE(test::saidWhyInOneLine(ended)) << ended.err;
    EXPECT_THAT(ended.err, HasSubstr(".obj"));
  }
}

TEST_F(Apply, doesNotWriteOverWhatItReads) {
  const std::string before = test::bytesOf(at("source.ply")),
                    stored = test::bytesOf(at("of-source.ply") + "/registered.ply");
  fs::create_symlink(at("source.ply"), at("link.ply"));
  for (const std::string output : {"source.ply", "link.ply", "of-source.ply/registered.ply"}) {
    const ProgramRun ended = apply("of-source.ply", "source.ply", output);
    EXPECT_EQ(ended.exit_code, 3) << output;
    EXPECT_TRUE(test::saidWhyInOneLine(ended)) << ended.err;
  }
  EXPECT_EQ(test::bytesOf(at("source.ply")), before);
  EXPECT_EQ(test::bytesOf(at("of-source.ply") + "/registered.ply"), stored);
}

TEST_F(Apply, refusesPointsThatAreNowhereNearTheSource) {
  const Points source = body(0).mesh.vertices;
  writeCloud("millimetres.xyz", 1000 * source);
  writeCloud("elsewhere.xyz", source.rowwise() + Eigen::RowVector3d(5e5, 5e6, 0));
  for (const std::string points : {"millimetres.xyz", "elsewhere.xyz"}) {
    const ProgramRun ended = apply("of-source.ply", points, "never.xyz");
    EXPECT_EQ(ended.exit_code, 3) << points;
    EXPECT_TRUE(test::saidWhyInOneLine(ended)) << ended.err;
    EXPECT_THAT(ended.err, HasSubstr(points));
    EXPECT_FALSE(fs::exists(at("never.xyz")));
  }
  // Some strays among them are none.
  Points strays = source;
  strays.topRows(100).array() += 50;
  writeCloud("strays.xyz", strays);
  const ProgramRun ended = apply("of-source.ply", "strays.xyz", "moved-strays.xyz");
  EXPECT_EQ(ended.exit_code, 0);
  EXPECT_THAT(ended.out, HasSubstr("100 points of them far from SOURCE"));
}

TEST_F(Apply, namesWhatIsMissingInOneLine) {
  for (const std::string missing : {"report.json", "registered.ply", "source_colored.ply"}) {
    const std::string part = "without-" + missing;
    fs::copy(at("of-source.ply"), at(part));
    fs::remove(at(part) + "/" + missing);
    const ProgramRun ended = apply(part, "source.ply", "never.ply");
    EXPECT_EQ(ended.exit_code, 3);
    EXPECT_TRUE(test::saidWhyInOneLine(ended)) << ended.out << ended.err;
    EXPECT_THAT(ended.err, HasSubstr(missing));
  }
  EXPECT_EQ(apply("nowhere", "source.ply", "never.ply").exit_code, 3);
  EXPECT_EQ(apply("of-source.ply", "nowhere.ply", "never.ply").exit_code, 3);
  EXPECT_FALSE(fs::exists(at("never.ply")));
}

}  // namespace
}  // namespace posture
