// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/io/correspondence_io.h>
#include <posture/io/mesh_io.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "apps/program.h"
#include "support/bodies.h"
#include "support/shapes.h"
#include <algorithm>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <memory>
#include <set>
#include <sstream>

namespace posture {
namespace {

using nlohmann::json;
using test::ProgramRun;
using test::TemporaryFolder;
using testing::HasSubstr;
using testing::StartsWith;

namespace fs = std::filesystem;

const std::string POSTURE = std::string(PROGRAM_DIR) + "/posture";
const std::vector<std::string> RESULTS = {"correspondence.csv",
                                          "registered.ply",
                                          "report.html",
                                          "report.json",
                                          "segments.ply",
                                          "source_colored.ply",
                                          "target_colored.ply"};

ProgramRun registerShapes(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), "register");
  return test::run(POSTURE, arguments);
}

std::vector<fs::path> filesIn(const fs::path& folder) {
  std::vector<fs::path> files;
  if (fs::exists(folder))
    for (const auto& entry : fs::directory_iterator(folder)) files.push_back(entry.path());
  return files;
}

TriangleMesh body(int pose) { return test::body(pose, 1000, pose).mesh; }

/// With a vertex in no face, a second vertex at the place of the first, and a loose triangle.
TriangleMesh untidy(const TriangleMesh& mesh) {
  const int n = static_cast<int>(mesh.vertices.rows());
  TriangleMesh more{Points(n + 5, 3), Faces(mesh.faces.rows() + 1, 3)};
  more.vertices << mesh.vertices, mesh.vertices.row(0), mesh.vertices.topRows(4);
  more.vertices.bottomRows(4).col(2).array() += 2;
  more.faces << mesh.faces, n + 2, n + 3, n + 4;
  *std::find(more.faces.data(), more.faces.data() + more.faces.size(), 0) = n;
  return more;
}

/// Two poses of a body, registered twice: by one thread with --json, by two with --quiet and
/// --dump.
class Register : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = std::make_unique<TemporaryFolder>();
    writeMesh(at("source.ply"), untidy(body(0)));
    writeMesh(at("target.off"), body(1));
    one_thread_ = registerShapes(
        {at("source.ply"), at("target.off"), "-o", at("one"), "--threads", "1", "--json"});
    // What a run that was killed left: no report tells of it.
    fs::create_directory(at("two"));
    for (const char* file : {"two/alternative-7.csv", "two/correspondence_back.csv"})
      std::ofstream(at(file)) << "of a run before\n";
    fs::create_directory(at("dump"));
    for (const char* file : {"dump/77-candidate-9-target.ply", "dump/78-mine.ply"})
      std::ofstream(at(file)) << "of a run before, and the user's own\n";
    std::ofstream(at("dump/stages.txt")) << "77-candidate-9-target.ply\n";
    two_threads_ = registerShapes({at("source.ply"),
                                   at("target.off"),
                                   "-o",
                                   at("two"),
                                   "--threads",
                                   "2",
                                   "--quiet",
                                   "--dump",
                                   at("dump")});
  }
  static void TearDownTestSuite() { folder_.reset(); }

  void SetUp() override {
    ASSERT_EQ(one_thread_.exit_code, 0) << one_thread_.err;
    ASSERT_EQ(two_threads_.exit_code, 0) << two_threads_.err;
  }

  static std::string at(const std::string& name) { return *folder_ / name; }

  static std::string result(const std::string& run, const std::string& name) {
    return test::bytesOf(fs::path(at(run)) / name);
  }

  static json report(const std::string& run) { return json::parse(result(run, "report.json")); }

  static inline std::unique_ptr<TemporaryFolder> folder_;
  static inline ProgramRun one_thread_, two_threads_;
};

TEST_F(Register, writesItsFilesAndNoOthers) {
  for (const char* run : {"one", "two"}) {
    std::vector<std::string> names;
    for (const fs::path& file : filesIn(at(run))) names.push_back(file.filename().string());
    EXPECT_THAT(names, testing::UnorderedElementsAreArray(RESULTS));
  }
}

TEST_F(Register, hasARowForEveryVertexAsGivenInOrder) {
  const TriangleMesh source = readMesh(at("source.ply")).mesh,
                     target = readMesh(at("target.off")).mesh;
  std::istringstream rows(result("one", "correspondence.csv"));
  std::string row;
  ASSERT_TRUE(std::getline(rows, row));
  EXPECT_EQ(row, "source,target,face,b0,b1,b2,confidence");
  int v = 0;
  for (; std::getline(rows, row); ++v) EXPECT_THAT(row, StartsWith(std::to_string(v) + ","));
  EXPECT_EQ(v, source.vertices.rows());

  const Correspondence map = readCorrespondence(at("one") + "/correspondence.csv");
  int accepted = 0;
  for (const SurfacePoint& place : map.on_target) {
    EXPECT_LT(place.vertex, target.vertices.rows());
    EXPECT_LT(place.face, target.faces.rows());
    accepted += place.vertex >= 0;
  }
  EXPECT_GT(accepted, source.vertices.rows() / 2);
  EXPECT_EQ(map.on_target[source.vertices.rows() - 5].vertex, map.on_target[0].vertex);
}

TEST_F(Register, keepsVerticesAndFacesOfWhatItColoursAndMoves) {
  const TriangleMesh source = readMesh(at("source.ply")).mesh,
                     target = readMesh(at("target.off")).mesh;
  const MeshFile moved = readMesh(at("one") + "/registered.ply");
  EXPECT_EQ(moved.mesh.vertices.rows(), source.vertices.rows());
  EXPECT_EQ(moved.mesh.faces, source.faces);
  EXPECT_TRUE(moved.mesh.vertices.allFinite());
  for (const auto& [name, mesh] :
       {std::pair("/source_colored.ply", &source), std::pair("/target_colored.ply", &target)}) {
    const MeshFile colored = readMesh(at("one") + name);
    const Points in_single = mesh->vertices.cast<float>().cast<double>();
    EXPECT_EQ(colored.mesh.vertices, in_single) << name;
    EXPECT_EQ(colored.mesh.faces, mesh->faces) << name;
    EXPECT_EQ(colored.colors.rows(), mesh->vertices.rows()) << name;
  }
}

TEST_F(Register, reportsWhatWasCompared) {
  const json said = report("one");
  EXPECT_EQ(said.at("status"), "registered");
  for (const char* field : {"hypotheses", "consistency_threshold_c0"})  // of --paper
    EXPECT_FALSE(said.contains(field)) << field;
  EXPECT_FALSE(said.at("trust").contains("runner_up_energy_ratio"));
  ASSERT_GE(said.at("alternatives").size(), 1u);
  EXPECT_EQ(said.at("alternatives")[0].at("chosen"), true);
  EXPECT_GE(said.at("trust").at("trust"), 0.5);
  EXPECT_EQ(said.at("source").at("vertices"), readMesh(at("source.ply")).mesh.vertices.rows());
  EXPECT_EQ(said.at("source").at("cleaning").at("unreferenced_vertices"), 1);
  EXPECT_EQ(said.at("source").at("cleaning").at("welded_vertices"), 1);
  EXPECT_EQ(said.at("source").at("cleaning").at("components"), 2);
  EXPECT_EQ(said.at("run").at("threads"), 1);
  EXPECT_EQ(report("two").at("run").at("threads"), 2);
  EXPECT_THAT(result("one", "report.html"), HasSubstr("</html>"));
}

TEST_F(Register, oneThreadAndTwoGiveTheSameBytes) {
  for (const std::string& name : RESULTS)
    if (name.find("report") == std::string::npos) {
      EXPECT_EQ(result("one", name), result("two", name)) << name;
    }
  json one = report("one"), two = report("two");
  one.erase("run");
  two.erase("run");
  EXPECT_EQ(one, two);
  std::string page_one = result("one", "report.html"), page_two = result("two", "report.html");
  page_one.resize(page_one.rfind("<h2"));  // the last section is about the run
  page_two.resize(page_two.rfind("<h2"));
  EXPECT_EQ(page_one, page_two);
}

TEST_F(Register, doesNotDumpOverAnInput) {
  fs::create_directory(at("stages"));
  const std::string stage = at("stages/01-target-main-surface.ply");
  writeMesh(stage, body(1));
  const std::string before = test::bytesOf(stage);
  const ProgramRun end =
      registerShapes({at("source.ply"), stage, "-o", at("none"), "--dump", at("stages")});
  EXPECT_EQ(end.exit_code, 3);
  EXPECT_THAT(end.err, HasSubstr(stage + ": would be written over by the output"));
  EXPECT_EQ(test::bytesOf(stage), before);
}

TEST_F(Register, dumpsMeshesOfEveryStageInPlaceOfThoseOfARunBefore) {
  EXPECT_FALSE(fs::exists(at("dump/77-candidate-9-target.ply")));
  EXPECT_TRUE(fs::remove(at("dump/78-mine.ply")));
  std::istringstream list(test::bytesOf(at("dump/stages.txt")));
  std::set<std::string> listed;
  for (std::string name; std::getline(list, name);) listed.insert(name);
  EXPECT_TRUE(fs::remove(at("dump/stages.txt")));
  const auto files = filesIn(at("dump"));
  for (const fs::path& file : files) EXPECT_EQ(listed.count(file.filename().string()), 1u) << file;
  EXPECT_EQ(listed.size(), files.size());
  std::set<std::string> names;
  for (const fs::path& file : files) names.insert(file.stem().string().substr(3));
  for (const char* name : {"source-main-surface",
                           "target-work-mesh",
                           "source-canonical-form",
                           "target-eigenfunction",
                           "finalist-0-target",
                           "source-bent-onto-target"})
    EXPECT_EQ(names.count(name), 1u) << name;
  for (const fs::path& file : files) {
    EXPECT_EQ(file.extension(), ".ply");
    EXPECT_NO_THROW(readMesh(file)) << file;
  }
}

TEST_F(Register, saysNoMoreThanItIsAskedFor) {
  EXPECT_EQ(two_threads_.out, "");
  EXPECT_EQ(two_threads_.err, "");
  EXPECT_EQ(one_thread_.out, result("one", "report.json"));
  EXPECT_EQ(one_thread_.err, "");  // no bar where there is no terminal
}

TEST_F(Register, saysWhatItWasAskedForAndWhatItWrote) {
  const json said = report("one");
  EXPECT_EQ(said.at("options"),
            json({{"method", "refined"},
                  {"surface", "delaunay"},
                  {"both", "false"},
                  {"alternatives", "false"}}));
  for (const std::string& name : RESULTS) {
    if (name == "report.json" || name == "report.html") continue;
    EXPECT_TRUE(said.at("files").contains(name)) << name;
  }
}

TEST_F(Register, takesAShapeForItselfAndLeavesNothingOfAnEarlierResult) {
  const fs::path folder = at("again");
  fs::create_directory(folder);
  fs::copy_file(at("target.off"), folder / "shape.off");
  const auto write = [](const fs::path& path, const std::string& text) {
    std::ofstream(path) << text;
  };
  // What an earlier report lists goes, but for the input; what is elsewhere or not listed stays.
  const json files = {{"correspondence_back.csv", ""}, {"shape.off", ""}, {"../target.off", ""}};
  write(folder / "report.json", json({{"files", files}}).dump());
  const std::vector<std::string> stale{
      "correspondence_back.csv", "segments.json", "segments.csv", "pose-1_segments.ply"};
  for (const std::string& name : stale) write(folder / name, "old");
  write(folder / "notes.txt", "mine");
  const ProgramRun ended = registerShapes(
      {folder / "shape.off", folder / "shape.off", "-o", folder.string(), "--alternatives", "-q"});
  ASSERT_EQ(ended.exit_code, 0) << ended.err;
  std::set<std::string> names, listed{"report.json", "report.html", "notes.txt", "shape.off"};
  for (const fs::path& file : filesIn(folder)) names.insert(file.filename().string());
  const json report = json::parse(test::bytesOf(folder / "report.json"));
  for (const auto& file : report.at("files").items()) listed.insert(file.key());
  EXPECT_EQ(names, listed);
  EXPECT_EQ(names.count("alternative-1.csv"), 1u);
  EXPECT_TRUE(fs::exists(at("target.off")));
  EXPECT_EQ(report.at("options").at("alternatives"), "true");
  const Correspondence map = readCorrespondence(folder / "correspondence.csv");
  for (std::size_t v = 0; v < map.on_target.size(); ++v)
    EXPECT_EQ(map.on_target[v].vertex, static_cast<int>(v));
}

TEST_F(Register, anInterruptedRunLeavesWholeFilesOnly) {
  for (const int signal : {SIGINT, SIGTERM}) {
    const std::string name = "interrupted-" + std::to_string(signal);
    const fs::path dump = at(name + "-dump");
    const ProgramRun ended = test::runInterrupted(
        POSTURE,
        {"register", at("source.ply"), at("target.off"), "-o", at(name), "--dump", dump.string()},
        signal,
        [&] { return filesIn(dump).size() > 2; });
    EXPECT_EQ(ended.exit_code, 128 + signal) << ended.err;
    EXPECT_TRUE(filesIn(at(name)).empty());
    EXPECT_TRUE(fs::remove(dump / "stages.txt"));
    for (const fs::path& file : filesIn(dump)) {
      EXPECT_EQ(file.extension(), ".ply");
      EXPECT_NO_THROW(readMesh(file)) << file;
    }
  }
}

TEST_F(Register, findsTheWayBackOnRequest) {
  const ProgramRun ended =
      registerShapes({at("source.ply"), at("target.off"), "-o", at("both"), "--both", "-q"});
  ASSERT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_EQ(result("both", "correspondence.csv"), result("one", "correspondence.csv"));
  const Points source = readMesh(at("source.ply")).mesh.vertices;
  const Correspondence there = readCorrespondence(at("both") + "/correspondence.csv"),
                       back = readCorrespondence(at("both") + "/correspondence_back.csv");
  ASSERT_EQ(back.on_target.size(), readMesh(at("target.off")).mesh.vertices.rows());
  const double size =
      std::sqrt(report("both").at("source").at("main_surface").at("area").get<double>());
  double sum = 0;
  int count = 0;
  for (Eigen::Index v = 0; v < source.rows() - 4; ++v) {
    const int t = there.on_target[v].vertex;
    if (t < 0 || back.on_target[t].vertex < 0) continue;
    sum += (source.row(v) - source.row(back.on_target[t].vertex)).norm() / size;
    ++count;
  }
  ASSERT_GT(count, source.rows() / 2);
  const json agreement = report("both").at("trust").at("there_and_back");
  // Between vertices it is off by up to an edge more than between places.
  const double edge =
      report("both").at("source").at("main_surface").at("mean_edge_length").get<double>() / size;
  EXPECT_LT(agreement.at("mean_miss"), edge);
  EXPECT_NEAR(agreement.at("mean_miss"), sum / count, edge);
  EXPECT_GE(agreement.at("percentile_95_miss"), agreement.at("mean_miss"));
  EXPECT_FALSE(report("one").at("trust").contains("there_and_back"));
}

/// Runs that come to nothing, against a sound mesh.
class RegisterFails : public testing::Test {
 protected:
  void SetUp() override { writeMesh(folder_ / "sound.off", test::bentStrip(20, 6, 4, 1, 1.5)); }

  void write(const std::string& name, const std::string& bytes) const {
    std::ofstream(folder_ / name, std::ios::binary) << bytes;
  }

  /// One line that names the file, and no result, nor a folder for one.
  void expectFailure(const std::vector<std::string>& arguments,
                     int code,
                     const std::string& named) {
    const ProgramRun ended = registerShapes(arguments);
    EXPECT_EQ(ended.exit_code, code) << named << ": " << ended.err;
    EXPECT_TRUE(test::saidWhyInOneLine(ended)) << ended.out << ended.err;
    EXPECT_THAT(ended.err, HasSubstr(named));
    EXPECT_FALSE(fs::exists(folder_ / "out")) << named;
  }

  void expectUnusable(const std::string& name) {
    const std::string bad = folder_ / name, sound = folder_ / "sound.off", out = folder_ / "out";
    expectFailure({bad, sound, "-o", out}, 3, name);
    expectFailure({sound, bad, "-o", out}, 3, name);
  }

  const TemporaryFolder folder_;
};

TEST_F(RegisterFails, onFilesThatCannotBeRead) {
  expectUnusable("missing.ply");
  fs::create_directory(folder_ / "folder.ply");
  expectUnusable("folder.ply");
  write("empty.ply", "");
  expectUnusable("empty.ply");
  write("garbage.ply", std::string("\x7f\x45\x4c\x46\0\1\2\xff\xfe", 9) + std::string(500, '\xa7'));
  expectUnusable("garbage.ply");
  writeMesh(folder_ / "whole.ply", test::sphere(2));
  const std::string whole = test::bytesOf(folder_ / "whole.ply");
  write("truncated.ply", whole.substr(0, whole.size() / 2));
  expectUnusable("truncated.ply");
}

TEST_F(RegisterFails, onMeshesThatAreNone) {
  const std::string corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 1\n";
  write("nan.obj", corners + "v nan 0 0\nf 1 2 3\n");
  expectUnusable("nan.obj");
  write("range.obj", corners + "f 1 2 9\n");
  expectUnusable("range.obj");
  write("triangle.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  expectUnusable("triangle.obj");
  write("points.obj", corners);
  expectUnusable("points.obj");
  write("collapsed.obj", corners + "f 1 1 2\nf 3 3 3\n");
  expectUnusable("collapsed.obj");
  std::string line;
  for (int v = 0; v < 40; ++v) line += "v " + std::to_string(v) + " 0 0\n";
  for (int f = 1; f < 38; ++f)
    line +=
        "f " + std::to_string(f) + " " + std::to_string(f + 1) + " " + std::to_string(f + 2) + "\n";
  write("line.obj", line);
  expectUnusable("line.obj");
}

TEST_F(RegisterFails, whereItCannotWrite) {
  const std::string sound = folder_ / "sound.off";
  expectFailure({sound, sound, "-o", sound + "/out"}, 3, "sound.off/out");
  expectFailure({sound, sound, "-o", "/proc/self"}, 3, "/proc/self");
  expectFailure(
      {sound, sound, "-o", folder_ / "out", "--dump", sound + "/dump"}, 3, "sound.off/dump");
  expectFailure({sound, sound, "-o", folder_ / "out", "--dump", "/proc/self"}, 3, "/proc/self");
}

TEST_F(RegisterFails, whereItsResultsWouldTakeAnInputsPlace) {
  const std::string sound = folder_ / "sound.off", earlier = folder_ / "registered.ply",
                    link = folder_ / "link.ply";
  writeMesh(earlier, test::sphere(2));
  fs::create_symlink("registered.ply", link);
  const std::string before = test::bytesOf(earlier);
  for (const std::string& input : {earlier, link}) {
    expectFailure({input, sound, "-o", folder_.path()}, 3, "written over");
    expectFailure({sound, input, "-o", folder_.path()}, 3, "written over");
  }
  EXPECT_EQ(test::bytesOf(earlier), before);
}

TEST_F(RegisterFails, onWrongUsage) {
  const std::string sound = folder_ / "sound.off", out = folder_ / "out";
  expectFailure({sound, sound}, 2, "--output");
  expectFailure({sound, "-o", out}, 2, "TARGET");
  expectFailure({sound, sound, "-o", out, "--both", "--paper"}, 2, "--paper");
  expectFailure({sound, sound, "-o", out, "--nonsense"}, 2, "--nonsense");
  expectFailure({sound, sound, "-o", out, "--threads", "0"}, 2, "--threads");
}

TEST_F(RegisterFails, toDecideOnUnrelatedShapes) {
  writeMesh(folder_ / "ball.ply", test::sphere(3));
  writeMesh(folder_ / "body.ply", body(0));
  const ProgramRun ended =
      registerShapes({folder_ / "ball.ply", folder_ / "body.ply", "-o", folder_ / "out"});
  EXPECT_EQ(ended.exit_code, 1);
  EXPECT_TRUE(test::saidWhyInOneLine(ended)) << ended.out << ended.err;
}

}  // namespace
}  // namespace posture
