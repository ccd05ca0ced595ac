// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/rng.h>
#include <posture/io/shape_io.h>

#include <gtest/gtest.h>

#include "io/encode.h"
#include "support/files.h"
#include "support/shapes.h"
#include <string>

namespace posture {
namespace {

using test::TemporaryFolder;

constexpr int ROUNDS = 300;

/// Either a shape that hangs together or an InputError of one line that names the file.
void expectShapeOrInputError(const std::filesystem::path& path) {
  try {
    const Shape file = readShape(path);
    const PointCloud& cloud = file.cloud;
    EXPECT_GT(cloud.points.rows(), 0);
    EXPECT_TRUE(file.faces.rows() == 0 || cloud.points.allFinite());
    EXPECT_TRUE(cloud.normals.rows() == 0 || cloud.normals.rows() == cloud.points.rows());
    EXPECT_TRUE(cloud.normals.allFinite());
    EXPECT_TRUE(cloud.colors.rows() == 0 || cloud.colors.rows() == cloud.points.rows());
    EXPECT_TRUE(cloud.width == 0 || cloud.points.rows() % cloud.width == 0);
    EXPECT_TRUE(!cloud.sensor || cloud.sensor->allFinite());
  } catch (const InputError& error) {
    const std::string message = error.what();
    EXPECT_EQ(message.rfind(path.string() + ": ", 0), 0u) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  }
}

std::vector<test::EncodedMesh> samples() {
  const std::string header =
      "# .PCD v0.7\nVERSION 0.7\nFIELDS x y z w rgb\nSIZE 4 4 4 2 4\nTYPE F F F U F\n"
      "COUNT 1 1 1 2 1\nWIDTH 2\nHEIGHT 2\nVIEWPOINT 0 0 1 1 0 0 0\nPOINTS 4\nDATA ";
  std::string binary;
  for (int i = 0; i < 20; ++i) binary += test::raw(static_cast<float>(i));
  // Literals of 16 bytes, then 64 that are the same.
  const std::string lzf = '\x0f' + binary.substr(0, 16) + "\xe0\x37\x0f";
  const std::string sizes =
      test::raw(static_cast<std::uint32_t>(lzf.size())) + test::raw(static_cast<std::uint32_t>(80));
  std::vector<test::EncodedMesh> files = {
      {"ascii.pcd", header + "ascii\n1 2 3 4 5 6\n1 2 3 4 5 6\nnan nan nan 0 0 0\n7 8 9 1 1 1\n"},
      {"binary.pcd", header + "binary\n" + binary},
      {"compressed.pcd", header + "binary_compressed\n" + sizes + lzf},
      {"names.csv", "x,y,z,nx,ny,nz\n1,2,3,0,0,1\n-4,5e3,6.5,,,\nnan,nan,nan,0,1,0\n"},
      {"scan.pts", "2\n1 2 3 -500 255 0 9\n4 5 6 20 1 2 3\n1\n7 8 9 1 2 3 4\n"},
      {"nine.xyz", "# a comment\n1 2 3 255 0 0 0 0 1\n4 5 6 0 9 0 0 1 0 // end\n"}};
  for (const test::EncodedMesh& mesh : test::encodeEveryWay(test::grid(2, 1, 1, 1)))
    files.push_back(mesh);
  return files;
}

TEST(DamagedShape, isReadOrRefused) {
  const TemporaryFolder folder;
  Rng rng(1);
  for (const auto& [name, bytes] : samples())
    for (int round = 0; round < ROUNDS; ++round) {
      const std::string damaged = test::damage(bytes, rng);
      expectShapeOrInputError(folder.file(name, damaged));
      ASSERT_FALSE(HasFailure()) << name << " round " << round << ":\n" << damaged;
    }
}

TEST(DamagedShape, everyTruncationIsReadOrRefused) {
  const TemporaryFolder folder;
  for (const auto& [name, bytes] : samples()) {
    expectShapeOrInputError(folder.file(name, bytes));
    for (std::size_t size = 1; size < bytes.size(); ++size) {
      expectShapeOrInputError(folder.file(name, bytes.substr(0, size)));
      ASSERT_FALSE(HasFailure()) << name << " cut to " << size;
    }
  }
}

TEST(DamagedShape, samplesAreWhole) {
  const TemporaryFolder folder;
  for (const auto& [name, bytes] : samples())
    EXPECT_EQ(test::inputErrorOf([&, path = folder.file(name, bytes)] { readShape(path); }), "");
}

TEST(DamagedShape, noiseIsReadOrRefused) {
  const TemporaryFolder folder;
  Rng rng(2);
  const char* const starts[] = {
      "",
      "x y z\n",
      "9\n",
      "# .PCD\nFIELDS x y z\nWIDTH 9\nDATA ascii\n",
      "# .PCD\nFIELDS x y z\nWIDTH 9\nDATA binary\n",
      "# .PCD\nFIELDS x y z\nWIDTH 9\nDATA binary_compressed\n\x40\0\0\0\x6c\0\0\0"};
  for (const char* const start : starts)
    for (const char* ending : {".pcd", ".xyz", ".csv", ".pts"})
      for (int round = 0; round < 40; ++round) {
        std::string bytes = start;
        for (int i = rng.below(400); i >= 0; --i) bytes += static_cast<char>(rng.below(256));
        expectShapeOrInputError(folder.file(std::string("noise") + ending, bytes));
      }
}

}  // namespace
}  // namespace posture
