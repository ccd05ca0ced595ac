// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/rng.h>
#include <posture/io/correspondence_io.h>
#include <posture/io/mesh_io.h>

#include <gtest/gtest.h>

#include "io/encode.h"
#include "support/files.h"
#include "support/shapes.h"
#include <string>

namespace posture {
namespace {

using test::TemporaryFolder;

constexpr int ROUNDS = 300;

/// Either a mesh that hangs together or an InputError of one line that names the file.
void expectMeshOrInputError(const std::filesystem::path& path) {
  try {
    const MeshFile file = readMesh(path);
    EXPECT_GT(file.mesh.vertices.rows(), 0);
    EXPECT_TRUE(file.mesh.vertices.allFinite());
    EXPECT_TRUE(file.normals.rows() == 0 || file.normals.rows() == file.mesh.vertices.rows());
    EXPECT_TRUE(file.colors.rows() == 0 || file.colors.rows() == file.mesh.vertices.rows());
    if (file.mesh.faces.rows() == 0) return;
    EXPECT_GE(file.mesh.faces.minCoeff(), 0);
    EXPECT_LT(file.mesh.faces.maxCoeff(), file.mesh.vertices.rows());
  } catch (const InputError& error) {
    const std::string message = error.what();
    EXPECT_EQ(message.rfind(path.string() + ": ", 0), 0u) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  }
}

std::vector<test::EncodedMesh> samples() {
  std::vector<test::EncodedMesh> files = test::encodeEveryWay(test::grid(2, 1, 1, 1));
  files.push_back({"full.obj",
                   "v 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 0 1 0 0 0 1\nvn 0 0 1\nvt 0 0\n"
                   "f 1/1/1 2/1/1 -1/-1/-1\nf 1 2 \\\n3\n"});
  files.push_back({"full.off",
                   "CNOFF 3 1 0\n0 0 0 0 0 1 9 9 9 9\n1 0 0 0 0 1 9 9 9\n0 1 0 0 0 1 1.0 0 0\n"
                   "3 0 1 2 9 9 9\n"});
  files.push_back({"full.ply",
                   "ply\nformat ascii 1.0\nelement a 1\nproperty list int int b\nelement vertex 3\n"
                   "property float x\nproperty float y\nproperty float z\nproperty uchar red\n"
                   "property uchar green\nproperty uchar blue\nelement tristrips 1\n"
                   "property list int int vertex_indices\nend_header\n2 5 6\n0 0 0 1 2 3\n"
                   "1 0 0 4 5 6\n0 1 0 7 8 9\n7 0 1 2 -1 2 1 0\n"});
  return files;
}

TEST(DamagedMesh, isReadOrRefused) {
  const TemporaryFolder folder;
  Rng rng(1);
  for (const auto& [name, bytes] : samples())
    for (int round = 0; round < ROUNDS; ++round) {
      const std::string damaged = test::damage(bytes, rng);
      expectMeshOrInputError(folder.file(name, damaged));
      ASSERT_FALSE(HasFailure()) << name << " round " << round << ":\n" << damaged;
    }
}

TEST(DamagedMesh, everyTruncationIsReadOrRefused) {
  const TemporaryFolder folder;
  for (const auto& [name, bytes] : samples())
    for (std::size_t size = 1; size < bytes.size(); ++size) {
      expectMeshOrInputError(folder.file(name, bytes.substr(0, size)));
      ASSERT_FALSE(HasFailure()) << name << " cut to " << size;
    }
}

TEST(DamagedMesh, noiseBehindEverySignatureIsReadOrRefused) {
  const TemporaryFolder folder;
  Rng rng(2);
  const char* const starts[] = {"",
                                "ply\n",
                                "ply\nformat binary_big_endian 1.0\nelement vertex 9\n",
                                "OFF ",
                                "solid\n",
                                "# vtk DataFile Version 5.1\nt\nBINARY\nDATASET POLYDATA\nPOINTS "};
  for (const char* const start : starts)
    for (const char* ending : {".obj", ".off", ".ply", ".stl", ".vtk"})
      for (int round = 0; round < 20; ++round) {
        std::string bytes = start;
        for (int i = rng.below(400); i >= 0; --i) bytes += static_cast<char>(rng.below(256));
        expectMeshOrInputError(folder.file(std::string("noise") + ending, bytes));
      }
}

TEST(DamagedTable, isReadOrRefused) {
  const TemporaryFolder folder;
  Rng rng(3);
  const std::string table =
      "source,target,face,b0,b1,b2,confidence\n0,7,3,0.1,0.7,0.2,0.5\n1,-1,-1,0,0,0,0\n";
  for (int round = 0; round < 2 * ROUNDS; ++round) {
    const auto path = folder.file("c.csv", test::damage(table, rng));
    test::inputErrorOf([&] { readCorrespondence(path); });
    test::inputErrorOf(
        [&] { readVertexPairs(folder.file("p.txt", test::damage("0 1\n2 3\n", rng))); });
  }
}

}  // namespace
}  // namespace posture
