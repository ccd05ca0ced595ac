// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/mesh/edges.h>
#include <posture/mesh/normals.h>
#include <posture/mesh/rigid_motion.h>

#include <gtest/gtest.h>

#include "refined/completion/draw_piece.h"
#include "refined/completion/target_part.h"
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
/// \param bow  to one side; with it the limb is not its own mirror image.
TriangleMesh limb(double turned = 0, double bow = 0.1) {
  TriangleMesh mesh = test::sphere(4);
  mesh.vertices =
      mesh.vertices * Eigen::AngleAxisd(turned, Eigen::Vector3d(1, 2, 3).normalized()).matrix();
  for (auto p : mesh.vertices.rowwise()) {
    const double along = 0.5 * (p.z() + 1);
    p = Eigen::RowVector3d((0.09 + 0.05 * along) * p.x() + 0.25 * along * along,
                           (0.13 - 0.04 * along) * p.y() + bow * std::sin(4 * along),
                           along);
  }
  return mesh;
}

Eigen::Isometry3d turn(double angle, const Eigen::Vector3d& axis) {
  return Eigen::Isometry3d(Eigen::AngleAxisd(angle, axis.normalized()));
}

/// A mesh to lay pieces on, all of it.
struct Target {
  explicit Target(TriangleMesh of, double size = 3)
      : mesh(std::move(of)), surface(mesh, vertexNormals(mesh), meanEdgeLength(mesh), size) {}

  TargetPart part() const {
    std::vector<int> all(mesh.vertices.rows());
    std::iota(all.begin(), all.end(), 0);
    return {surface, all};
  }

  TriangleMesh mesh;
  PieceTarget surface;
};

TriangleMesh movedMesh(const Eigen::Isometry3d& motion, const TriangleMesh& mesh) {
  return {moved(motion, mesh.vertices), mesh.faces};
}

Piece pieceOf(const TriangleMesh& mesh) {
  Piece piece{mesh.vertices,
              vertexNormals(mesh),
              0,
              boundaryVertices(mesh.faces, static_cast<int>(mesh.vertices.rows()))};
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
  std::vector<int> order(piece.vertices.rows());
  std::iota(order.begin(), order.end(), 0);
  std::shuffle(order.begin(), order.end(), std::mt19937(3));
  TriangleMesh shuffled = movedMesh(b, target.mesh);
  for (std::size_t v = 0; v < order.size(); ++v)
    shuffled.vertices.row(order[v]) =
        (b * target.mesh.vertices.row(static_cast<int>(v)).transpose()).transpose();
  for (int& v : shuffled.faces.reshaped()) v = order[v];
  const Target elsewhere(shuffled);
  Piece other = pieceOf(movedMesh(a, piece));
  std::shuffle(order.begin(), order.end(), std::mt19937(4));
  other.first =
      static_cast<int>(std::find(order.begin(), order.end(), in_order.first) - order.begin());
  other.points = Points(other.points(order, Eigen::all));
  other.normals = Points(other.normals(order, Eigen::all));
  other.on_rim.assign(order.size(), 0);
  const auto there = drawPiece(elsewhere.part(), other, b * a.inverse());
  ASSERT_TRUE(there);
  EXPECT_LT(farthestOff(*there * a, b * *found, piece.vertices), 1e-9);
}

TEST(DrawPiece, saysNothingWhereAPieceFitsTwice) {
  // The same limb twice, at right angles.
  const TriangleMesh piece = limb();
  const TriangleMesh first = movedMesh(turn(0.8, {1, 0, 0}), piece),
                     second = movedMesh(turn(-0.8, {1, 0, 0}), piece);
  const Target target(test::joined(first, second)), one(first), other(second);
  EXPECT_TRUE(drawPiece(one.part(), pieceOf(piece), Eigen::Isometry3d::Identity()));
  EXPECT_TRUE(drawPiece(other.part(), pieceOf(piece), Eigen::Isometry3d::Identity()));
  EXPECT_FALSE(drawPiece(target.part(), pieceOf(piece), Eigen::Isometry3d::Identity()));
}

TEST(DrawPiece, isNotLaidOnItsMirrorImage) {
  // A body so small that the piece cannot lie the other way round, slightly bowed: it fits well
  // enough to be drawn.
  constexpr double SMALL = 2, SLIGHT = 0.03;
  const Piece piece = pieceOf(limb(0, SLIGHT));
  const auto isDrawn = [&](double bow) {
    const Target target(limb(0.5, bow), SMALL);
    return drawPiece(target.part(), piece, Eigen::Isometry3d::Identity()).has_value();
  };
  EXPECT_TRUE(isDrawn(SLIGHT));
  EXPECT_FALSE(isDrawn(-SLIGHT));
}

/// What of a mesh lies between two heights, in its own numbering.
TriangleMesh between(const TriangleMesh& mesh, double low, double high) {
  std::vector<int> number(mesh.vertices.rows(), -1), kept, faces;
  for (int v = 0; v < mesh.vertices.rows(); ++v)
    if (mesh.vertices(v, 2) >= low && mesh.vertices(v, 2) <= high) {
      number[v] = static_cast<int>(kept.size());
      kept.push_back(v);
    }
  for (int f = 0; f < mesh.faces.rows(); ++f)
    if ((mesh.faces.row(f).array().unaryExpr([&](int v) { return number[v]; }) >= 0).all())
      faces.push_back(f);
  TriangleMesh part{mesh.vertices(kept, Eigen::all), mesh.faces(faces, Eigen::all)};
  for (int& v : part.faces.reshaped()) v = number[v];
  return part;
}

/// An oval leg from -1 to 1, flat at both ends, that is thinner the higher it is counted from
/// `base`.
TriangleMesh leg(double base) {
  TriangleMesh mesh = test::sphere(4);
  for (auto p : mesh.vertices.rowwise()) {
    constexpr double SIDES = 0.9;  // of the sphere's height
    const double round = std::hypot(p.x(), p.y()), height = std::abs(p.z());
    const double z = std::clamp(p.z() / SIDES, -1.0, 1.0);
    const double radius =
        (1 - 0.6 * (z - base)) * (height < SIDES ? 1 : std::sqrt((1 - height) / (1 - SIDES)));
    const double share = round > 0 ? radius / round : 0;
    p = Eigen::RowVector3d(0.14 * share * p.x(), 0.1 * share * p.y(), z);
  }
  return mesh;
}

TEST(DrawPiece, aFootIsNotLaidOnTheMiddleOfALeg) {
  // The other leg has lost its foot; 0.6 below its end it is as thick as this foot.
  Piece foot = pieceOf(between(leg(0), 0.4, 1));
  ASSERT_GT(std::count(foot.on_rim.begin(), foot.on_rim.end(), 1), 10);
  const Target target(between(leg(-0.6), -1, 0.95));
  const Eigen::Isometry3d there(Eigen::Translation3d(0, 0, -0.6));
  EXPECT_FALSE(drawPiece(target.part(), foot, there));
  // If it were open at its end, it could be the middle of a leg.
  foot.on_rim.assign(foot.on_rim.size(), 1);
  const auto found = drawPiece(target.part(), foot, there);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->translation().z(), -0.6, 0.05);
}

TEST(DrawPiece, saysNothingWhereAPieceDoesNotFit) {
  TriangleMesh ball = test::sphere(4);
  ball.vertices *= 0.5;
  const Target target(ball);
  EXPECT_FALSE(drawPiece(target.part(), pieceOf(limb()), Eigen::Isometry3d::Identity()));
  EXPECT_FALSE(drawPiece({target.surface, {}}, pieceOf(limb()), Eigen::Isometry3d::Identity()));
}

}  // namespace
}  // namespace posture
