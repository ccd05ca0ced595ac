// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/rng.h>
#include <posture/mesh/background.h>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "support/bodies.h"
#include "support/shapes.h"
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace posture {
namespace {

using test::joined;
using Offset = Eigen::RowVector3d;

/// A closed box, with its faces divided.
TriangleMesh box(const Offset& from, const Offset& size) {
  TriangleMesh mesh;
  const TriangleMesh side = test::grid(8, 8, 1, 1);
  for (int axis = 0; axis < 3; ++axis)
    for (double at : {0.0, 1.0}) {
      TriangleMesh face = side;
      for (auto p : face.vertices.rowwise()) {
        const Offset q = p;
        p[axis] = from[axis] + at * size[axis];
        p[(axis + 1) % 3] = from[(axis + 1) % 3] + q.x() * size[(axis + 1) % 3];
        p[(axis + 2) % 3] = from[(axis + 2) % 3] + q.y() * size[(axis + 2) % 3];
      }
      mesh = mesh.vertices.rows() > 0 ? joined(mesh, face) : face;
    }
  return mesh;
}

/// A sheet that is flat, as a scanner sees it, about the origin and at a height of 0.
TriangleMesh floorOf(double size, double noise = 0) {
  TriangleMesh sheet = test::grid(40, 40, size, size);
  sheet.vertices.leftCols(2).array() -= 0.5 * size;
  Rng rng(3);
  for (double& z : sheet.vertices.col(2)) z = noise * rng.normal();
  return sheet;
}

TriangleMesh standingOn(const TriangleMesh& floor, TriangleMesh body) {
  const Offset low(0, 0, body.vertices.col(2).minCoeff() - 0.001);
  body.vertices.rowwise() -= low;
  return joined(body, floor);
}

const TriangleMesh& person(int pose) { return test::body(pose, 1500, 0, BodyKind::HUMAN).mesh; }
const TriangleMesh& animal(int pose) { return test::body(pose, 1500).mesh; }

int count(const TriangleMesh& mesh) {
  const std::vector<char> background = backgroundFaces(mesh);
  return static_cast<int>(std::count(background.begin(), background.end(), 1));
}

/// The floor, the second part of the mesh, and of the body nothing but its soles.
/// \param left  of the floor's faces, at most.
void expectFloorFound(const TriangleMesh& mesh,
                      int body_faces,
                      const std::string& what,
                      double left = 0) {
  SCOPED_TRACE(what);
  const std::vector<char> background = backgroundFaces(mesh);
  ASSERT_EQ(background.size(), static_cast<std::size_t>(mesh.faces.rows()));
  EXPECT_LE(std::count(background.begin() + body_faces, background.end(), 0),
            left * static_cast<double>(mesh.faces.rows() - body_faces));
  EXPECT_LT(std::count(background.begin(), background.begin() + body_faces, 1), 0.05 * body_faces);
}

TEST(BackgroundFaces, areThoseOfAFloorOfAnySize) {
  for (double size : {0.8, 1.5, 5.0})
    for (int pose : {0, 3}) {
      const std::string what = "size " + std::to_string(size) + ", pose " + std::to_string(pose);
      expectFloorFound(standingOn(floorOf(size), person(pose)),
                       static_cast<int>(person(pose).faces.rows()),
                       "person, " + what);
      expectFloorFound(standingOn(floorOf(size), animal(pose)),
                       static_cast<int>(animal(pose).faces.rows()),
                       "animal, " + what);
    }
}

TEST(BackgroundFaces, areFoundInAnyFrameAndUnitAndUnderNoise) {
  const TriangleMesh body = person(2);
  TriangleMesh mesh = standingOn(floorOf(1.5, 0.003), body);
  for (double unit : {1e-3, 1e4}) {
    mesh.vertices = unit * mesh.vertices *
                    Eigen::AngleAxisd(2, Eigen::Vector3d(1, 2, -2).normalized()).matrix();
    mesh.vertices.rowwise() += unit * Offset(5, -20, 7);
    expectFloorFound(
        mesh, static_cast<int>(body.faces.rows()), "unit " + std::to_string(unit), 0.02);
  }
}

TEST(BackgroundFaces, areFoundUnderABodyThatLies) {
  TriangleMesh body = person(1);
  body.vertices = body.vertices * Eigen::AngleAxisd(1.57, Eigen::Vector3d::UnitX()).matrix();
  const TriangleMesh mesh = standingOn(floorOf(2, 0.003), body);
  const std::vector<char> background = backgroundFaces(mesh);
  const auto of_body = static_cast<std::ptrdiff_t>(body.faces.rows());
  EXPECT_LT(std::count(background.begin() + of_body, background.end(), 0), 40);
  EXPECT_LT(std::count(background.begin(), background.begin() + of_body, 1), 0.2 * of_body);
}

TEST(BackgroundFaces, areFoundWhereBodyAndFloorAreOneSurface) {
  const TriangleMesh body = animal(0);
  TriangleMesh mesh = standingOn(floorOf(1.5), body);
  const auto m = mesh.faces.rows();
  mesh.faces.conservativeResize(m + 1, 3);
  Eigen::Index foot = 0;
  body.vertices.col(2).minCoeff(&foot);
  const auto first_of_floor = static_cast<int>(body.vertices.rows());
  mesh.faces.row(m) << static_cast<int>(foot), first_of_floor, first_of_floor + 1;
  expectFloorFound(mesh, static_cast<int>(body.faces.rows()), "joined by a face");
}

TEST(BackgroundFaces, areThoseOfAFloorAndTheWallsOfARoom) {
  const TriangleMesh body = person(1);
  TriangleMesh wall = floorOf(2);
  for (auto p : wall.vertices.rowwise()) p = Offset(p.x(), 1, p.y() + 1);
  TriangleMesh side = floorOf(2);
  for (auto p : side.vertices.rowwise()) p = Offset(-1, p.x(), p.y() + 1);
  expectFloorFound(joined(joined(standingOn(floorOf(2), body), wall), side),
                   static_cast<int>(body.faces.rows()),
                   "a corner");
}

TEST(BackgroundFaces, areThoseOfATurntableWithItsRim) {
  const TriangleMesh body = animal(4);
  TriangleMesh disc = test::sphere(5);
  for (auto p : disc.vertices.rowwise())
    p = Offset(0.5 * p.x(), 0.5 * p.y(), p.z() > 0 ? 0 : 0.1 * p.z());
  int kept = 0;  // its underside is not seen
  for (int f = 0; f < disc.faces.rows(); ++f)
    if (disc.vertices(disc.faces(f, 0), 2) > -0.02)
      disc.faces.row(kept++) = disc.faces.row(f).eval();
  disc.faces.conservativeResize(kept, 3);
  expectFloorFound(standingOn(disc, body), static_cast<int>(body.faces.rows()), "turntable");
}

TEST(BackgroundFaces, bodiesHaveNone) {
  for (int pose = 0; pose < 10; ++pose) {
    EXPECT_EQ(count(person(pose)), 0) << pose;
    EXPECT_EQ(count(animal(pose)), 0) << pose;
  }
  EXPECT_EQ(count(test::sphere(3)), 0);
  EXPECT_EQ(count(test::torus(40, 20, 1, 0.3)), 0);
}

TEST(BackgroundFaces, flatPartsOfABodyAreNone) {
  EXPECT_EQ(count(box({0, 0, 0}, {1, 1, 1})), 0) << "a cube";
  EXPECT_EQ(count(box({0, 0, 0}, {1, 0.6, 0.1})), 0) << "a plate";
  TriangleMesh table = box({0, 0, 0.6}, {1, 0.6, 0.05});
  for (double x : {0.05, 0.85})
    for (double y : {0.05, 0.45}) table = joined(table, box({x, y, 0}, {0.1, 0.1, 0.6}));
  EXPECT_EQ(count(table), 0) << "a table";
  TriangleMesh dome = test::sphere(5);
  for (auto p : dome.vertices.rowwise()) p.z() = std::max(0.0, p.z());
  EXPECT_EQ(count(dome), 0) << "what has a flat base";
  TriangleMesh man = box({-0.1, -0.3, 0}, {0.2, 0.6, 0.06});
  man = joined(man, box({-0.4, 0.1, 0}, {0.8, 0.1, 0.06}));
  EXPECT_EQ(count(man), 0) << "a cross of boards";
}

TEST(BackgroundFaces, sheetsHaveNone) {
  EXPECT_EQ(count(test::grid(40, 20, 2, 1)), 0);
  for (double angle : {0.5, 1.0, 2.0, 4.0})
    EXPECT_EQ(count(test::bentStrip(40, 20, 2, 1, angle)), 0) << angle;
  for (double degrees : {60, 90, 120}) {
    TriangleMesh folded = test::grid(40, 20, 2, 1);
    const double angle = degrees * 3.14159265 / 180;
    for (auto p : folded.vertices.rowwise())
      if (p.x() > 1)
        p = Offset(1 - (p.x() - 1) * std::cos(angle), p.y(), (p.x() - 1) * std::sin(angle));
    EXPECT_EQ(count(folded), 0) << degrees;
  }
}

TEST(BackgroundFaces, aFloorAloneAndAMeshWithoutAreaHaveNone) {
  EXPECT_EQ(count(floorOf(1, 0.001)), 0);
  TriangleMesh line = test::grid(4, 4, 1, 1);
  line.vertices.rightCols(2).setZero();
  EXPECT_EQ(count(line), 0);
  EXPECT_EQ(count({line.vertices, Faces(0, 3)}), 0);
}

TEST(BackgroundFaces, areNotLimbsThatHangPastTheEdge) {
  // Seated, looking along y, on a table that ends before the shins.
  const ArticulatedBody seated = test::body(2, 1500, 0, BodyKind::HUMAN);
  const TriangleMesh& body = seated.mesh;
  const auto faces = static_cast<int>(body.faces.rows());
  double height = 1, edge = 1;
  for (int v = 0; v < body.vertices.rows(); ++v) {
    const std::string bone = seated.bone_names[seated.bone[v]];
    if (bone == "pelvis") height = std::min(height, body.vertices(v, 2) - 0.001);
    if (bone.rfind("shin", 0) == 0) edge = std::min(edge, body.vertices(v, 1) - 0.005);
  }
  ASSERT_GT((body.vertices.col(2).array() < height - 0.1).count(), 100);
  TriangleMesh table = test::grid(40, 40, 1, 0.8);
  table.vertices.rowwise() += Offset(-0.5, edge - 0.8, height);
  expectFloorFound(joined(body, table), faces, "a table");
  // What hangs from the table itself goes with it: a cloth over its edge.
  TriangleMesh cloth = test::grid(40, 10, 1, 0.2);
  for (auto p : cloth.vertices.rowwise()) {
    const Offset q = p;
    p << q.x() - 0.5, edge - 0.8, height - q.y();
  }
  expectFloorFound(joined(body, joined(table, cloth)), faces, "a table with a cloth");
}

}  // namespace
}  // namespace posture
