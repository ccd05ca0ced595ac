// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/mesh/edges.h>
#include <posture/mesh/normals.h>

#include <gtest/gtest.h>

#include "draw_piece.h"
#include "support/shapes.h"
#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

namespace posture {
namespace {

/// A crooked limb of three different radii, one unit long, that begins at the origin. Turned on
/// itself before it is shaped, it has its vertices elsewhere.
TriangleMesh limb(double turned = 0) {
  TriangleMesh mesh = test::sphere(4);
  mesh.vertices =
      mesh.vertices * Eigen::AngleAxisd(turned, Eigen::Vector3d(1, 2, 3).normalized()).matrix();
  for (auto p : mesh.vertices.rowwise()) {
    const double along = 0.5 * (p.z() + 1);
    p = Eigen::RowVector3d((0.09 + 0.05 * along) * p.x() + 0.25 * along * along,
                           (0.13 - 0.04 * along) * p.y() + 0.1 * std::sin(4 * along),
                           along);
  }
  return mesh;
}

Eigen::Isometry3d turn(double angle, const Eigen::Vector3d& axis) {
  return Eigen::Isometry3d(Eigen::AngleAxisd(angle, axis.normalized()));
}

/// A mesh to lay pieces on, all of it.
struct Target {
  explicit Target(TriangleMesh surface) : mesh(std::move(surface)), normals(vertexNormals(mesh)) {}

  TargetPart part() const {
    std::vector<int> all(mesh.vertices.rows());
    std::iota(all.begin(), all.end(), 0);
    return {mesh.vertices, normals, all, meanEdgeLength(mesh), 3};
  }

  TriangleMesh mesh;
  Points normals;
};

TriangleMesh movedMesh(const Eigen::Isometry3d& motion, const TriangleMesh& mesh) {
  return {moved(motion, mesh.vertices), mesh.faces};
}

Piece pieceOf(const TriangleMesh& mesh) {
  Piece piece{mesh.vertices, vertexNormals(mesh)};
  mesh.vertices.rowwise().norm().minCoeff(&piece.first);
  return piece;
}

double farthestOff(const Eigen::Isometry3d& found,
                   const Eigen::Isometry3d& truth,
                   const Points& points) {
  return (moved(found, points) - moved(truth, points)).rowwise().norm().maxCoeff();
}

TEST(DrawPiece, findsAPieceThatBentAtItsRoot) {
  const TriangleMesh piece = limb();
  for (const Eigen::Vector3d& axis : {Eigen::Vector3d(1, 0.2, 0), Eigen::Vector3d(-0.3, 1, 0.5)}) {
    const Eigen::Isometry3d truth = Eigen::Translation3d(2, 1, 0) * turn(1.3, axis);
    const Target target(movedMesh(truth, limb(0.5)));
    const auto found =
        drawPiece(target.part(), pieceOf(piece), Eigen::Isometry3d(Eigen::Translation3d(2, 1, 0)));
    ASSERT_TRUE(found);
    EXPECT_LT(farthestOff(*found, truth, piece.vertices), 1.5 * meanEdgeLength(piece));
  }
}

TEST(DrawPiece, doesNotDependOnFramesAndOrder) {
  const TriangleMesh piece = limb();
  const Target target(movedMesh(turn(1.3, {1, 0.2, 0}), limb(0.5)));
  const Piece in_order = pieceOf(piece);
  const auto found = drawPiece(target.part(), in_order, Eigen::Isometry3d::Identity());
  ASSERT_TRUE(found);

  const Eigen::Isometry3d a = Eigen::Translation3d(5, 0, 3) * turn(2, {1, -1, 3}),
                          b = Eigen::Translation3d(-1, 2, 7) * turn(0.7, {0, 2, 1});
  const Target elsewhere(movedMesh(b, target.mesh));
  Piece other = pieceOf(movedMesh(a, piece));
  std::vector<int> order(piece.vertices.rows());
  std::iota(order.begin(), order.end(), 0);
  std::shuffle(order.begin(), order.end(), std::mt19937(4));
  other.first =
      static_cast<int>(std::find(order.begin(), order.end(), in_order.first) - order.begin());
  other.points = Points(other.points(order, Eigen::all));
  other.normals = Points(other.normals(order, Eigen::all));
  const auto there = drawPiece(elsewhere.part(), other, b * a.inverse());
  ASSERT_TRUE(there);
  EXPECT_LT(farthestOff(*there * a, b * *found, piece.vertices), 1e-9);
}

TEST(DrawPiece, saysNothingWhereAPieceFitsTwice) {
  // The same limb twice, at right angles.
  const TriangleMesh piece = limb();
  TriangleMesh both = movedMesh(turn(0.8, {1, 0, 0}), piece);
  const TriangleMesh second = movedMesh(turn(-0.8, {1, 0, 0}), piece);
  const auto n = both.vertices.rows(), m = both.faces.rows();
  both.vertices.conservativeResize(2 * n, 3);
  both.vertices.bottomRows(n) = second.vertices;
  both.faces.conservativeResize(2 * m, 3);
  both.faces.bottomRows(m) = second.faces.array() + static_cast<int>(n);
  const Target target(both), one(movedMesh(turn(0.8, {1, 0, 0}), piece)), other(second);
  EXPECT_TRUE(drawPiece(one.part(), pieceOf(piece), Eigen::Isometry3d::Identity()));
  EXPECT_TRUE(drawPiece(other.part(), pieceOf(piece), Eigen::Isometry3d::Identity()));
  EXPECT_FALSE(drawPiece(target.part(), pieceOf(piece), Eigen::Isometry3d::Identity()));
}

TEST(DrawPiece, saysNothingWhereAPieceDoesNotFit) {
  TriangleMesh ball = test::sphere(4);
  ball.vertices *= 0.5;
  const Target target(ball);
  EXPECT_FALSE(drawPiece(target.part(), pieceOf(limb()), Eigen::Isometry3d::Identity()));
  EXPECT_FALSE(drawPiece(
      {ball.vertices, target.normals, {}, 0.1, 3}, pieceOf(limb()), Eigen::Isometry3d::Identity()));
}

}  // namespace
}  // namespace posture
