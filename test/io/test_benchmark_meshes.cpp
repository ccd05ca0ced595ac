// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/io/correspondence_io.h>
#include <posture/io/mesh_io.h>

#include <gtest/gtest.h>

#include "support/benchmark.h"
#include "support/files.h"
#include <algorithm>
#include <sstream>

namespace posture {
namespace {

namespace fs = std::filesystem;

class BenchmarkMeshes : public test::BenchmarkTest {};

struct Counts {
  long vertices = 0, faces = 0;
};

/// From the file's head; for OBJ, which has none, by counting lines.
Counts declaredCounts(const fs::path& path) {
  std::istringstream text(test::bytesOf(path));
  Counts counts;
  std::string line, word;
  if (path.extension() == ".off") {
    text >> word >> counts.vertices >> counts.faces;
    return counts;
  }
  while (std::getline(text, line) && line != "end_header") {
    if (line.rfind("v ", 0) == 0) ++counts.vertices;
    if (line.rfind("f ", 0) == 0) ++counts.faces;
    if (line.rfind("element vertex ", 0) == 0) counts.vertices = std::stol(line.substr(15));
    if (line.rfind("element face ", 0) == 0) counts.faces = std::stol(line.substr(13));
  }
  return counts;
}

TEST_F(BenchmarkMeshes, haveTheCountsThatTheirFilesDeclare) {
  int count = 0;
  for (const auto& entry : fs::recursive_directory_iterator(folder_ / "meshes")) {
    if (!entry.is_regular_file()) continue;
    SCOPED_TRACE(entry.path().string());
    const Counts declared = declaredCounts(entry.path());
    MeshFile file;
    ASSERT_NO_THROW(file = readMesh(entry.path()));
    EXPECT_EQ(file.mesh.vertices.rows(), declared.vertices);
    EXPECT_EQ(file.mesh.faces.rows(), declared.faces);
    ++count;
  }
  EXPECT_GT(count, 0);
}

TEST_F(BenchmarkMeshes, truthFilesHaveAPairALine) {
  for (const auto& entry : fs::directory_iterator(folder_ / "truth")) {
    const std::string text = test::bytesOf(entry.path());
    const auto lines = std::count(text.begin(), text.end(), '\n');
    EXPECT_EQ(static_cast<long>(readVertexPairs(entry.path()).size()), lines) << entry.path();
  }
}

}  // namespace
}  // namespace posture
