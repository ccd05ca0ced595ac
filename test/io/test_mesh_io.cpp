// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/io/mesh_io.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/encode.h"
#include "support/files.h"
#include "support/shapes.h"
#include <clocale>
#include <limits>

namespace posture {
namespace {

using test::bytesOf;
using test::inputErrorOf;
using test::TemporaryFolder;
using ::testing::HasSubstr;

/// A sphere with coordinates that are exact in single precision.
TriangleMesh coarseSphere() {
  TriangleMesh mesh = test::sphere(2);
  mesh.vertices = (mesh.vertices * 4096).array().round().matrix() / 4096;
  return mesh;
}

Colors someColors(Eigen::Index count) {
  Colors colors(count, 3);
  for (Eigen::Index i = 0; i < count; ++i) colors.row(i) << i % 256, (7 * i) % 256, 255 - i % 256;
  return colors;
}

/// The positions of all corners one after the other: STL has no vertex numbers.
Points corners(const TriangleMesh& mesh) {
  Points points(3 * mesh.faces.rows(), 3);
  for (Eigen::Index i = 0; i < points.rows(); ++i)
    points.row(i) = mesh.vertices.row(mesh.faces(i / 3, i % 3));
  return points;
}

TEST(ReadMesh, everyFormatAndEncodingGivesTheSameMesh) {
  const TemporaryFolder folder;
  const TriangleMesh mesh = coarseSphere();
  for (const auto& [name, bytes] : test::encodeEveryWay(mesh)) {
    SCOPED_TRACE(name);
    const MeshFile file = readMesh(folder.file(name, bytes));
    EXPECT_EQ(file.mesh.faces.rows(), mesh.faces.rows());
    EXPECT_EQ(corners(file.mesh), corners(mesh));
    EXPECT_EQ(file.colors.rows(), 0);
    if (name.find(".stl") != std::string::npos) continue;
    EXPECT_EQ(file.mesh.vertices, mesh.vertices);
    EXPECT_EQ(file.mesh.faces, mesh.faces);
  }
}

TEST(ReadMesh, windowsLinesAndNoLastLineEndMakeNoDifference) {
  const TemporaryFolder folder;
  const TriangleMesh mesh = test::sphere(1);
  for (const auto& [name, bytes] : test::encodeEveryWay(mesh)) {
    if (bytes.find('\0') != std::string::npos) continue;
    SCOPED_TRACE(name);
    std::string windows;
    for (const char c : bytes) windows += c == '\n' ? "\r\n" : std::string(1, c);
    EXPECT_EQ(corners(readMesh(folder.file(name, windows)).mesh), corners(mesh));
    windows.erase(windows.find_last_not_of("\r\n") + 1);
    EXPECT_EQ(corners(readMesh(folder.file(name, windows)).mesh), corners(mesh));
  }
}

TEST(ReadMesh, signatureCountsMoreThanTheEnding) {
  const TemporaryFolder folder;
  const TriangleMesh mesh = test::sphere(0);
  for (const auto& [name, bytes] : test::encodeEveryWay(mesh)) {
    if (name == "mesh.obj") continue;
    EXPECT_EQ(readMesh(folder.file(name + ".data", bytes)).mesh.faces.rows(), 20) << name;
  }
}

class WriteMesh : public ::testing::TestWithParam<const char*> {};

TEST_P(WriteMesh, losesNothing) {
  const TemporaryFolder folder;
  const auto path = folder.path() / (std::string("mesh") + GetParam());
  TriangleMesh mesh = test::sphere(3);
  mesh.vertices.row(0) << 1e-300, -1.0 / 3, std::numeric_limits<double>::max();
  mesh.vertices.row(1) << std::numeric_limits<double>::denorm_min(), -0.0, 1e22;
  const Colors colors = someColors(mesh.vertices.rows());
  writeMesh(path, mesh, colors);
  const MeshFile file = readMesh(path);
  EXPECT_EQ(file.mesh.vertices, mesh.vertices);
  EXPECT_EQ(file.mesh.faces, mesh.faces);
  EXPECT_EQ(file.colors, colors);
  EXPECT_EQ(folder.names().size(), 1u);
}

TEST(WriteMesh, plyIsSingleWhereThatMovesNoVertexFarAndElseDouble) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "mesh.ply";
  TriangleMesh mesh = test::sphere(3);
  writeMesh(path, mesh);
  EXPECT_THAT(bytesOf(path), HasSubstr("\nproperty float x\n"));
  EXPECT_LT((readMesh(path).mesh.vertices - mesh.vertices).cwiseAbs().maxCoeff(), 1e-7);
  const auto expectDouble = [&](const TriangleMesh& written) {
    writeMesh(path, written);
    EXPECT_THAT(bytesOf(path), HasSubstr("\nproperty double x\n"));
    EXPECT_EQ(readMesh(path).mesh.vertices, written.vertices);
  };
  TriangleMesh far = mesh;
  far.vertices.array() += 1e5;
  expectDouble(far);
  TriangleMesh touching = mesh;
  touching.vertices.row(7) = touching.vertices.row(40) * (1 + 1e-9);
  expectDouble(touching);
}

TEST_P(WriteMesh, pointsWithoutFaces) {
  const TemporaryFolder folder;
  const auto path = folder.path() / (std::string("mesh") + GetParam());
  TriangleMesh mesh = test::grid(4, 2, 1, 1);
  mesh.faces.resize(0, 3);
  writeMesh(path, mesh);
  const MeshFile file = readMesh(path);
  EXPECT_EQ(file.mesh.vertices, mesh.vertices);
  EXPECT_EQ(file.mesh.faces.rows(), 0);
  EXPECT_EQ(file.colors.rows(), 0);
  EXPECT_EQ(file.normals.rows(), 0);
}

INSTANTIATE_TEST_SUITE_P(EveryFormat, WriteMesh, ::testing::Values(".ply", ".obj", ".off", ".PLY"));

TEST(WriteMesh, exactBytes) {
  const TemporaryFolder folder;
  TriangleMesh mesh = test::grid(1, 1, 1, 0.1);
  mesh.faces.conservativeResize(1, 3);
  const auto path = folder.path() / "mesh.obj";
  writeMesh(path, mesh);
  EXPECT_EQ(bytesOf(path), "v 0 0 0\nv 1 0 0\nv 0 0.1 0\nv 1 0.1 0\nf 1 2 4\n");
  const Colors white = Colors::Constant(4, 3, 255);
  writeMesh(folder.path() / "mesh.off", mesh, white);
  EXPECT_EQ(bytesOf(folder.path() / "mesh.off"),
            "COFF\n4 1 0\n0 0 0 255 255 255 255\n1 0 0 255 255 255 255\n"
            "0 0.1 0 255 255 255 255\n1 0.1 0 255 255 255 255\n3 0 1 3\n");
}

TEST(WriteMesh, callersMistakesAreInvalidArguments) {
  const TemporaryFolder folder;
  const TriangleMesh mesh = test::grid(1, 1, 1, 1);
  EXPECT_THROW(writeMesh(folder.path() / "mesh.stl", mesh), std::invalid_argument);
  EXPECT_THROW(writeMesh(folder.path() / "mesh", mesh), std::invalid_argument);
  EXPECT_THROW(writeMesh(folder.path() / "mesh.ply", mesh, someColors(3)), std::invalid_argument);
  EXPECT_THAT(inputErrorOf([&] { writeMesh(folder.path() / "no" / "mesh.ply", mesh); }),
              HasSubstr("cannot be written"));
  EXPECT_EQ(folder.names().size(), 0u);
}

TEST(ReadMesh, doesNotDependOnTheLocale) {
  const TemporaryFolder folder;
  const auto path = folder.file("mesh.obj", "v 0.5 1.5 2.5\nv 1e-400 1e-320 3\n");
  const std::string before = std::setlocale(LC_ALL, nullptr);
  bool found = false;
  for (const char* name : {"de_DE.UTF-8", "de_DE.utf8", "fr_FR.UTF-8"})
    found = found || std::setlocale(LC_ALL, name) != nullptr;
  const MeshFile file = readMesh(path);
  writeMesh(folder.path() / "copy.obj", file.mesh);
  std::setlocale(LC_ALL, before.c_str());
  EXPECT_EQ(file.mesh.vertices.row(0), Eigen::RowVector3d(0.5, 1.5, 2.5));
  EXPECT_EQ(file.mesh.vertices.row(1), Eigen::RowVector3d(0, 1e-320, 3));
  EXPECT_EQ(bytesOf(folder.path() / "copy.obj"), "v 0.5 1.5 2.5\nv 0 1e-320 3\n");
  if (!found) GTEST_SKIP() << "no locale with a decimal comma is installed";
}

TEST(ReadMesh, aByteOrderMarkMayComeBeforeTheText) {
  const TemporaryFolder folder;
  for (const test::EncodedMesh& file : test::encodeEveryWay(test::grid(2, 1, 1, 1))) {
    if (file.name == "binary.stl" || file.name == "solid.stl") continue;
    SCOPED_TRACE(file.name);
    EXPECT_EQ(readMesh(folder.file(file.name, "\xef\xbb\xbf" + file.bytes)).mesh.faces.rows(), 4);
  }
}

}  // namespace
}  // namespace posture
