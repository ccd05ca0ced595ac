// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/mesh/edges.h>
#include <posture/refine/rigid_ends.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "refine/club.h"
#include "refine/poses.h"
#include "support/shapes.h"
#include <cmath>
#include <vector>

namespace posture {
namespace {

/// The farthest that a landmark is from the vertex it should be at, in edges. Vertices of both
/// share their numbering.
double farthestMiss(const SpectralSurface& target, const RigidEnd& end) {
  double miss = 0;
  for (const Landmark& landmark : end.landmarks)
    miss = std::max(
        miss, (target.mesh.vertices.row(landmark.a) - target.mesh.vertices.row(landmark.b)).norm());
  return miss / meanEdgeLength(target.mesh);
}

/// The club with its arm drawn out by a third, but for the hand.
TriangleMesh drawnOut(TriangleMesh club) {
  const double hand = club.vertices.col(0).maxCoeff() - 0.3, root = hand - 0.5;
  for (double& x : club.vertices.col(0))
    x += 0.15 * std::clamp((x - root) / (hand - root), 0.0, 1.0);
  return club;
}

class RigidEnds : public testing::Test {
 protected:
  VertexMaps woundBy(double angle) const {
    return {test::nearestOf(test::wound(club_.mesh, angle), club_.mesh),
            test::nearestOf(test::wound(club_.mesh, -angle), club_.mesh)};
  }

  const SpectralSurface club_ = test::spectralSurface(test::clubWithHand(2), 10);
  const int tip_ = test::tipOf(club_.mesh);
};

TEST_F(RigidEnds, aHandThatIsMappedTurnedIsLaidWhereItFits) {
  for (double angle : {-2.0, 1.3, M_PI}) {
    const std::vector<RigidEnd> ends = rigidEnds(club_, club_, {tip_}, woundBy(angle));
    ASSERT_EQ(ends.size(), 1) << angle;
    EXPECT_TRUE(ends[0].turned) << angle;
    EXPECT_EQ(ends[0].landmarks[0].a, tip_) << angle;
    EXPECT_LT(farthestMiss(club_, ends[0]), 1.5) << angle;
  }
}

TEST_F(RigidEnds, aHandThatIsMappedRightlyIsNotTurned) {
  const std::vector<RigidEnd> ends = rigidEnds(club_, club_, {tip_}, woundBy(0));
  ASSERT_EQ(ends.size(), 1);
  EXPECT_FALSE(ends[0].turned);
  EXPECT_LT(farthestMiss(club_, ends[0]), 1.5);
}

TEST_F(RigidEnds, anArmThatStretchesDoesNotHideTheHand) {
  const SpectralSurface other(
      drawnOut(club_.mesh), Matrix::Ones(club_.mesh.vertices.rows(), 1), Vector::Zero(1));
  const std::vector<RigidEnd> ends = rigidEnds(club_, other, {tip_}, woundBy(2));
  ASSERT_EQ(ends.size(), 1);
  EXPECT_TRUE(ends[0].turned);
  EXPECT_LT(farthestMiss(other, ends[0]), 1.5);
}

TEST_F(RigidEnds, landmarksAreSpreadOverTheEnd) {
  const std::vector<RigidEnd> ends = rigidEnds(club_, club_, {tip_}, woundBy(0));
  ASSERT_EQ(ends.size(), 1);
  const std::vector<Landmark>& landmarks = ends[0].landmarks;
  for (std::size_t i = 0; i < landmarks.size(); ++i) {
    EXPECT_THAT(ends[0].vertices, testing::Contains(landmarks[i].a));
    for (std::size_t j = 0; j < i; ++j)
      EXPECT_GT(club_.distances.from(landmarks[i].a)[landmarks[j].a], 0.05);
  }
}

TEST_F(RigidEnds, whatIsInOneEndIsNotLookedAtAgain) {
  const std::vector<double>& from_tip = club_.distances.from(tip_);
  const int beside = static_cast<int>(
      std::find_if(from_tip.begin(), from_tip.end(), [](double d) { return d > 0 && d < 0.05; }) -
      from_tip.begin());
  EXPECT_EQ(rigidEnds(club_, club_, {tip_, beside}, woundBy(0)).size(), 1);
}

TEST(RigidEndsOfRoundBodies, sayNothing) {
  TriangleMesh mesh = test::sphere(3);
  mesh.vertices.col(0) *= 3;
  const SpectralSurface egg = test::spectralSurface(mesh, 10);
  EXPECT_TRUE(rigidEnds(egg, egg, {test::tipOf(egg.mesh)}, test::identity(egg)).empty());
}

}  // namespace
}  // namespace posture
