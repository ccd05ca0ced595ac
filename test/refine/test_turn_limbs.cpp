// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/mesh/edges.h>
#include <posture/mesh/point_index.h>
#include <posture/refine/turn_limbs.h>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "refine/poses.h"
#include "support/shapes.h"
#include <algorithm>
#include <cmath>

namespace posture {
namespace {

/// A club with a round body, an arm along x and a flat hand at its end, with a thumb on one side
/// and a palm that is hollow: it fits itself in one way only. Of an area of one.
TriangleMesh clubWithHand() {
  TriangleMesh mesh = test::sphere(4);
  for (auto p : mesh.vertices.rowwise()) {
    const double x = p.x(), around = std::hypot(p.y(), p.z());
    const double out = std::clamp((x + 0.5) / 1.5, 0.0, 1.0);  // 0 on the body, 1 at the tip
    const double thin = 1 - 0.7 * std::clamp(out / 0.2, 0.0, 1.0);
    const double hand = std::clamp((out - 0.7) / 0.1, 0.0, 1.0);
    const double profile =
        around > 0 ? thin * (out > 0 ? std::sqrt(1 - out * out) + 0.2 * (1 - out) : around) / around
                   : 0;
    double y = p.y() * profile * (1 + 1.2 * hand), z = p.z() * profile * (1 - 0.4 * hand);
    if (y > 0) y *= 1 + 0.8 * hand * std::exp(-std::pow((out - 0.82) / 0.06, 2));  // thumb
    z -= 0.6 * hand * y * y;                                                       // palm
    p = Eigen::RowVector3d(x + 2.2 * out, y, z);
  }
  mesh.vertices /= std::sqrt(faceAreas(mesh).sum());
  return mesh;
}

int tipOf(const TriangleMesh& mesh) {
  Eigen::Index tip = 0;
  mesh.vertices.col(0).maxCoeff(&tip);
  return static_cast<int>(tip);
}

Points wound(const TriangleMesh& mesh, double angle) {
  const double tip = mesh.vertices.col(0).maxCoeff();
  Points places = mesh.vertices;
  for (auto p : places.rowwise()) {
    const double share = std::clamp((0.4 - (tip - p.x())) / 0.25, 0.0, 1.0);
    p = (Eigen::AngleAxisd(share * angle, Eigen::Vector3d::UnitX()) * Eigen::Vector3d(p))
            .transpose();
  }
  return places;
}

std::vector<int> nearestOf(const Points& from, const TriangleMesh& to) {
  const PointIndex index(to.vertices);
  std::vector<int> nearest;
  for (const auto& p : from.rowwise()) nearest.push_back(index.nearest(p.transpose()).index);
  return nearest;
}

/// Soft, then stiff.
void settleWell(const SpectralSurface& club, BentPair& pair) {
  const double softness = club.eigenvalues[club.eigenvalues.size() - 1];
  for (double share : {0.03, 0.1, 0.3, 1.0}) settle(club, club, share * softness, 6, pair);
}

/// The club on itself, its arm wound about itself, and settled.
BentPair settledFrom(const SpectralSurface& club, double angle) {
  BentPair pair{{}, wound(club.mesh, angle), wound(club.mesh, -angle)};
  pair.maps = {nearestOf(pair.bent_a, club.mesh), nearestOf(pair.bent_b, club.mesh)};
  settleWell(club, pair);
  return pair;
}

/// In edges, of what is within 0.5 of the tip.
double meanMiss(const TriangleMesh& mesh, const std::vector<int>& map) {
  const double tip = mesh.vertices.col(0).maxCoeff();
  double sum = 0;
  int count = 0;
  for (std::size_t v = 0; v < map.size(); ++v) {
    if (tip - mesh.vertices(static_cast<Eigen::Index>(v), 0) > 0.5) continue;
    sum += (mesh.vertices.row(map[v]) - mesh.vertices.row(static_cast<Eigen::Index>(v))).norm();
    ++count;
  }
  return sum / (count * meanEdgeLength(mesh));
}

class TurnLimbs : public testing::Test {
 protected:
  bool turn(BentPair& pair) const {
    const std::vector<LimbTurn> turns = likelyTurns(club_, club_, tip_, softness_, pair, 3);
    const bool turned = turnLimb(club_, club_, tip_, softness_, turns, pair);
    settleWell(club_, pair);
    return turned;
  }

  const SpectralSurface club_ = test::spectralSurface(clubWithHand(), 100);
  const int tip_ = tipOf(club_.mesh);
  const double softness_ = club_.eigenvalues[club_.eigenvalues.size() - 1];
};

TEST_F(TurnLimbs, whatFitsStays) {
  BentPair pair = settledFrom(club_, 0);
  EXPECT_FALSE(turn(pair));
  EXPECT_LT(meanMiss(club_.mesh, pair.maps.forward), 0.1);
}

TEST_F(TurnLimbs, aHandWithItsBackWhereThePalmBelongsIsTurned) {
  BentPair pair = settledFrom(club_, M_PI);
  EXPECT_GT(meanMiss(club_.mesh, pair.maps.forward), 1);  // settling alone leaves it there
  EXPECT_TRUE(turn(pair));
  EXPECT_LT(meanMiss(club_.mesh, pair.maps.forward), 0.3);
  EXPECT_LT(meanMiss(club_.mesh, pair.maps.backward), 0.3);
}

TEST(TurnLimb, aBallHasNoLimbs) {
  TriangleMesh ball = test::sphere(3);
  ball.vertices /= std::sqrt(faceAreas(ball).sum());
  const SpectralSurface surface = test::spectralSurface(ball, 60);
  const std::vector<int> same = nearestOf(ball.vertices, ball);
  EXPECT_TRUE(likelyTurns(surface, surface, 0, 100, {{same, same}, ball.vertices, ball.vertices}, 3)
                  .empty());
}

TEST_F(TurnLimbs, nothingToTryWhereTheSurfaceIsTooSmall) {
  // No face of this one is within reach of a corner; a sphere of twelve vertices is.
  TriangleMesh large = test::sphere(0);
  large.vertices *= 10;
  const SpectralSurface wide(large, Matrix::Zero(12, 1), Vector::Zero(1));
  const std::vector<int> itself = nearestOf(large.vertices, large);
  EXPECT_TRUE(likelyTurns(wide, wide, 0, 10, {{itself, itself}, large.vertices, large.vertices}, 3)
                  .empty());
  const SpectralSurface crumb = test::spectralSurface(test::sphere(0), 4);
  const std::vector<int> same = nearestOf(crumb.mesh.vertices, crumb.mesh);
  BentPair pair{{same, same}, crumb.mesh.vertices, crumb.mesh.vertices};
  EXPECT_TRUE(likelyTurns(crumb, crumb, 0, 10, pair, 3).empty());
  EXPECT_FALSE(turnLimb(crumb, crumb, 0, 10, {{M_PI, 0.1, 0.35}}, pair));
  EXPECT_EQ(pair.maps.forward, same);
}

}  // namespace
}  // namespace posture
