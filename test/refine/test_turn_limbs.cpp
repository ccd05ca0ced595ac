// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/refine/settle.h>
#include <posture/refine/turn_limbs.h>

#include <gtest/gtest.h>

#include "refine/club.h"
#include "refine/poses.h"
#include "support/shapes.h"
#include "support/unit_area.h"
#include <cmath>
#include <vector>

namespace posture {
namespace {

/// Stiff, then soft.
void settleWell(const SpectralSurface& a, const SpectralSurface& b, BentPair& pair) {
  const double softness = a.eigenvalues[a.eigenvalues.size() - 1];
  for (double share : {0.03, 0.1, 0.3, 1.0}) settle(a, b, share * softness, 6, pair);
}

/// A club on another one, its arm wound about itself, and settled.
BentPair settledFrom(const SpectralSurface& a, const SpectralSurface& b, double angle) {
  BentPair pair{{}, test::wound(a.mesh, angle), test::wound(b.mesh, -angle)};
  pair.maps = {test::nearestOf(pair.bent_a, b.mesh), test::nearestOf(pair.bent_b, a.mesh)};
  settleWell(a, b, pair);
  return pair;
}

BentPair settledFrom(const SpectralSurface& club, double angle) {
  return settledFrom(club, club, angle);
}

class TurnLimbs : public testing::Test {
 protected:
  bool turn(BentPair& pair) const {
    const std::vector<LimbTurn> turns = likelyTurns(club_, club_, tip_, softness_, pair, 3);
    const bool turned = turnLimb(club_, club_, tip_, softness_, turns, pair);
    settleWell(club_, club_, pair);
    return turned;
  }

  const SpectralSurface club_ = test::spectralSurface(test::clubWithHand(), 100);
  const int tip_ = test::tipOf(club_.mesh);
  const double softness_ = club_.eigenvalues[club_.eigenvalues.size() - 1];
};

TEST_F(TurnLimbs, whatFitsStays) {
  BentPair pair = settledFrom(club_, 0);
  EXPECT_FALSE(turn(pair));
  EXPECT_LT(test::meanMiss(club_.mesh, pair.maps.forward), 0.1);
}

TEST_F(TurnLimbs, aHandWithItsBackWhereThePalmBelongsIsTurned) {
  BentPair pair = settledFrom(club_, M_PI);
  EXPECT_GT(test::meanMiss(club_.mesh, pair.maps.forward), 1);  // settling alone leaves it there
  EXPECT_TRUE(turn(pair));
  EXPECT_LT(test::meanMiss(club_.mesh, pair.maps.forward), 0.3);
  EXPECT_LT(test::meanMiss(club_.mesh, pair.maps.backward), 0.3);
}

/// The same club with a smaller thumb: an exact copy settles by itself once it is laid anew.
class RefitLimbEnds : public TurnLimbs {
 protected:
  BentPair annealedFrom(double angle) const {
    BentPair pair = settledFrom(club_, other_, angle);
    anneal(club_, other_, softness_, pair);
    return pair;
  }
  bool refitEnd(BentPair& pair) const { return refitLimbEnd(club_, other_, tip_, softness_, pair); }

  const SpectralSurface other_ = test::spectralSurface(test::clubWithHand(0.6), 100);
};

TEST_F(RefitLimbEnds, whatFitsStays) {
  BentPair pair = annealedFrom(0);
  const BentPair before = pair;
  EXPECT_FALSE(refitEnd(pair));
  EXPECT_EQ(pair.maps.forward, before.maps.forward);
  EXPECT_EQ(pair.bent_a, before.bent_a);
}

TEST_F(RefitLimbEnds, aHandWithItsBackWhereThePalmBelongsIsTurned) {
  BentPair pair = annealedFrom(M_PI);
  EXPECT_GT(test::meanMiss(club_.mesh, pair.maps.forward), 1);
  const BentPair before = pair;
  EXPECT_TRUE(refitEnd(pair));
  anneal(club_, other_, softness_, pair);
  EXPECT_LT(test::meanMiss(club_.mesh, pair.maps.forward), 0.5);
  EXPECT_LT(test::meanMiss(club_.mesh, pair.maps.backward), 0.5);
  EXPECT_TRUE(limbFitsBetter(club_, other_, tip_, softness_, before, pair));
  EXPECT_FALSE(limbFitsBetter(club_, other_, tip_, softness_, pair, before));
}

TEST_F(RefitLimbEnds, whatIsTornBehindTheEndCounts) {
  const BentPair before = annealedFrom(0);
  BentPair torn = before;
  const std::vector<double>& from_tip = club_.distances.from(tip_);
  for (int v = 0; v < club_.mesh.vertices.rows(); ++v)
    if (from_tip[v] > 0.25 && from_tip[v] < 0.35) torn.bent_a.row(v) = before.bent_a.row(tip_);
  EXPECT_FALSE(limbFitsBetter(club_, other_, tip_, softness_, before, torn));
  EXPECT_TRUE(limbFitsBetter(club_, other_, tip_, softness_, torn, before));
}

TEST_F(RefitLimbEnds, aHandThatFitsInNoWayIsLeftAlone) {
  TriangleMesh crumpled = test::clubWithHand(0.6);
  const double tip = crumpled.vertices.col(0).maxCoeff();
  const Points off = 0.01 * test::randomPoints(static_cast<int>(crumpled.vertices.rows()), 1);
  for (int v = 0; v < crumpled.vertices.rows(); ++v)
    if (tip - crumpled.vertices(v, 0) < 0.25) crumpled.vertices.row(v) += off.row(v);
  const SpectralSurface other = test::spectralSurface(std::move(crumpled), 100);
  BentPair pair = settledFrom(club_, other, M_PI);
  anneal(club_, other, softness_, pair);
  const BentPair before = pair;
  EXPECT_FALSE(refitLimbEnd(club_, other, tip_, softness_, pair));
  EXPECT_EQ(pair.maps.forward, before.maps.forward);
  EXPECT_EQ(pair.bent_a, before.bent_a);
}

TEST(TurnLimb, aBallHasNoLimbs) {
  const TriangleMesh ball = test::unitArea(test::sphere(3));
  const SpectralSurface surface = test::spectralSurface(ball, 60);
  const std::vector<int> same = test::nearestOf(ball.vertices, ball);
  BentPair pair{{same, same}, ball.vertices, ball.vertices};
  EXPECT_TRUE(likelyTurns(surface, surface, 0, 100, pair, 3).empty());
}

TEST_F(TurnLimbs, nothingToTryWhereTheSurfaceIsTooSmall) {
  // No face of this one is within reach of a corner; a sphere of twelve vertices is.
  TriangleMesh large = test::sphere(0);
  large.vertices *= 10;
  const SpectralSurface wide(large, Matrix::Zero(12, 1), Vector::Zero(1));
  const std::vector<int> itself = test::nearestOf(large.vertices, large);
  BentPair on_itself{{itself, itself}, large.vertices, large.vertices};
  EXPECT_TRUE(likelyTurns(wide, wide, 0, 10, on_itself, 3).empty());
  EXPECT_FALSE(refitLimbEnd(wide, wide, 0, 10, on_itself));
  const SpectralSurface crumb = test::spectralSurface(test::sphere(0), 4);
  const std::vector<int> same = test::nearestOf(crumb.mesh.vertices, crumb.mesh);
  BentPair pair{{same, same}, crumb.mesh.vertices, crumb.mesh.vertices};
  EXPECT_TRUE(likelyTurns(crumb, crumb, 0, 10, pair, 3).empty());
  EXPECT_FALSE(turnLimb(crumb, crumb, 0, 10, {{M_PI, 0.1, 0.35}}, pair));
  EXPECT_FALSE(refitLimbEnd(crumb, crumb, 0, 10, pair));
  EXPECT_EQ(pair.maps.forward, same);
}

}  // namespace
}  // namespace posture
