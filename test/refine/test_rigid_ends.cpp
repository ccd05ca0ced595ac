// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/mesh/edges.h>
#include <posture/refine/rigid_ends.h>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "refine/club.h"
#include "refine/poses.h"
#include "support/shapes.h"
#include "support/unit_area.h"
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace posture {
namespace {

/// The farthest that a place is from where it should be, in edges: less than 2, as it is laid next
/// to a vertex, and thumbs differ. Vertices of both share their numbering.
double farthestMiss(const SpectralSurface& target, const RigidEnd& end) {
  double miss = 0;
  for (const PlacePair& place : end.places)
    miss = std::max(miss,
                    (target.mesh.vertices.row(place.a) - target.mesh.vertices.row(place.b)).norm());
  return miss / meanEdgeLength(target.mesh);
}

/// The club with its arm drawn out by a third, but for the hand.
TriangleMesh drawnOut(TriangleMesh club) {
  const double hand = club.vertices.col(0).maxCoeff() - 0.22, root = hand - 0.5;
  for (double& x : club.vertices.col(0))
    x += 0.15 * std::clamp((x - root) / (hand - root), 0.0, 1.0);
  return club;
}

/// A hand with a long thumb fits another one in one way only.
class RigidEnds : public testing::Test {
 protected:
  /// Of one club onto the other.
  VertexMaps woundBy(double angle) const {
    return {test::nearestOf(test::wound(club_.mesh, angle), other_.mesh),
            test::nearestOf(test::wound(other_.mesh, -angle), club_.mesh)};
  }

  const SpectralSurface club_ = test::spectralSurface(test::clubWithHand(4), 10),
                        other_ = test::spectralSurface(test::clubWithHand(3.5), 10);
  const int tip_ = test::tipOf(club_.mesh);
};

TEST_F(RigidEnds, aHandThatIsMappedTurnedIsLaidWhereItFits) {
  for (double angle : {-2.0, 1.3, M_PI}) {
    const std::vector<RigidEnd> ends = rigidEnds(club_, other_, {tip_}, woundBy(angle));
    ASSERT_EQ(ends.size(), 1) << angle;
    EXPECT_TRUE(ends[0].turned) << angle;
    ASSERT_EQ(ends[0].places.size(), 5) << angle;
    EXPECT_LT(farthestMiss(other_, ends[0]), 2) << angle;
    const Eigen::Vector3d tip = club_.mesh.vertices.row(tip_),
                          there = other_.mesh.vertices.row(tip_);
    EXPECT_LT((ends[0].motion * tip - there).norm(), 2 * meanEdgeLength(other_.mesh)) << angle;
  }
}

TEST_F(RigidEnds, aHandThatIsMappedRightlyIsNotTurned) {
  const std::vector<RigidEnd> ends = rigidEnds(club_, other_, {tip_}, woundBy(0));
  ASSERT_EQ(ends.size(), 1);
  EXPECT_FALSE(ends[0].turned);
  ASSERT_EQ(ends[0].places.size(), 5);
  EXPECT_LT(farthestMiss(other_, ends[0]), 2);
}

TEST_F(RigidEnds, anArmThatStretchesDoesNotHideTheHand) {
  const SpectralSurface stretched(
      drawnOut(other_.mesh), Matrix::Ones(other_.mesh.vertices.rows(), 1), Vector::Zero(1));
  const std::vector<RigidEnd> ends = rigidEnds(club_, stretched, {tip_}, woundBy(2));
  ASSERT_EQ(ends.size(), 1);
  EXPECT_TRUE(ends[0].turned);
  EXPECT_LT(farthestMiss(stretched, ends[0]), 2);
}

TEST_F(RigidEnds, placesAreSpreadOverTheEnd) {
  const std::vector<RigidEnd> ends = rigidEnds(club_, other_, {tip_}, woundBy(0));
  ASSERT_EQ(ends.size(), 1);
  const std::vector<PlacePair>& places = ends[0].places;
  ASSERT_EQ(places.size(), 5);
  for (std::size_t i = 0; i < places.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      EXPECT_GT(club_.distances.from(places[i].a)[places[j].a], 0.05);
}

TEST_F(RigidEnds, whatIsInOneEndIsNotLookedAtAgain) {
  const std::vector<double>& from_tip = club_.distances.from(tip_);
  const int beside = static_cast<int>(
      std::find_if(from_tip.begin(), from_tip.end(), [](double d) { return d > 0 && d < 0.05; }) -
      from_tip.begin());
  EXPECT_EQ(rigidEnds(club_, other_, {tip_, beside}, woundBy(0)).size(), 1);
}

class RightHand : public testing::Test {
 protected:
  /// With a palm that is twice as hollow: what tells a right one from a left one.
  static TriangleMesh withPalm(double thumb) {
    TriangleMesh mesh = test::clubWithHand(thumb, 5);
    mesh.vertices.col(2) *= 2;
    return test::unitArea(std::move(mesh));
  }
  static SpectralSurface mirrored(TriangleMesh mesh) {
    mesh.vertices.col(2) *= -1;
    mesh.faces.col(1).swap(mesh.faces.col(2));
    return test::spectralSurface(mesh, 10);
  }
  VertexMaps onto(const SpectralSurface& other) const {
    return {test::nearestOf(hand_.mesh.vertices, other.mesh),
            test::nearestOf(other.mesh.vertices, hand_.mesh)};
  }
  std::vector<EndFit> fitOn(const SpectralSurface& other) const {
    return fitEnds(hand_, other, {test::tipOf(hand_.mesh)}, onto(other));
  }
  /// \param tips_of_other  whether the end is looked at from the other side, too.
  HandVote voteOn(const SpectralSurface& other, bool tips_of_other) const {
    std::vector<int> tips;
    if (tips_of_other) tips.push_back(test::tipOf(other.mesh));
    return handVote(hand_, other, {test::tipOf(hand_.mesh)}, tips, onto(other));
  }

  const SpectralSurface hand_ = test::spectralSurface(withPalm(4), 10),
                        like_ = test::spectralSurface(withPalm(3.5), 10),
                        unlike_ = mirrored(withPalm(3.5));
};

TEST_F(RightHand, fitsItsLikeBetterThanALeftOne) {
  const std::vector<EndFit> right = fitOn(like_), left = fitOn(unlike_);
  ASSERT_EQ(right.size(), 1);
  ASSERT_EQ(left.size(), 1);
  EXPECT_TRUE(right[0].fitsInOneWay());
  EXPECT_GT(left[0].misfit, 2 * right[0].misfit);
  const std::vector<double> against = endDisagreements({right, left});
  EXPECT_EQ(against[0], 0);
  EXPECT_GT(against[1], 0);
}

TEST_F(RightHand, speaksForAMapToARightOneAndAgainstOneToALeftOneOnce) {
  for (bool both_ways : {false, true}) {
    const HandVote right = voteOn(like_, both_ways), left = voteOn(unlike_, both_ways);
    EXPECT_EQ(right.for_it, 1);
    EXPECT_EQ(right.against_it, 0);
    EXPECT_EQ(left.for_it, 0);
    EXPECT_EQ(left.against_it, 1);
  }
}

TEST_F(RigidEnds, anEndThatIsItsOwnMirrorImageSpeaksNeitherWay) {
  // Without the thumb.
  const SpectralSurface paddle = test::spectralSurface(test::clubWithHand(0), 10);
  std::vector<int> same(paddle.mesh.vertices.rows());
  std::iota(same.begin(), same.end(), 0);
  const HandVote vote = handVote(paddle, paddle, {test::tipOf(paddle.mesh)}, {}, {same, same});
  EXPECT_EQ(vote.for_it, 0);
  EXPECT_EQ(vote.against_it, 0);
}

TEST_F(RigidEnds, anEndThatIsNotAllThereDoesNotTell) {
  const auto fitOn = [&](const std::function<bool(int)>& is_there) {
    TriangleMesh open = other_.mesh;
    std::vector<int> kept;
    for (int f = 0; f < open.faces.rows(); ++f) {
      const auto face = open.faces.row(f);
      if (std::all_of(face.begin(), face.end(), is_there)) kept.push_back(f);
    }
    open.faces = Faces(open.faces(kept, Eigen::all));
    const SpectralSurface rest(open, Matrix::Ones(open.vertices.rows(), 1), Vector::Zero(1));
    return fitEnds(club_, rest, {tip_}, woundBy(0)).at(0).misfit;
  };
  const Points& places = other_.mesh.vertices;
  const int beside = other_.within_two_edges.begin(tip_)[0];
  EXPECT_LT(fitOn([&](int v) { return v != beside; }), 0.01);  // but for a few faces
  const double hand = places(tip_, 0) - 0.2;
  EXPECT_TRUE(
      std::isinf(fitOn([&](int v) { return places(v, 0) < hand || places(v, 1) > -0.01; })));
}

TEST_F(RigidEnds, anEndWithTooFewVerticesDoesNotTell) {
  const TriangleMesh rough = test::sphere(1);
  const SpectralSurface ball(rough, Matrix::Ones(rough.vertices.rows(), 1), Vector::Zero(1));
  const VertexMaps maps{test::nearestOf(club_.mesh.vertices, rough),
                        test::nearestOf(rough.vertices, club_.mesh)};
  const std::vector<EndFit> fits = fitEnds(club_, ball, {tip_}, maps);
  ASSERT_EQ(fits.size(), 1);
  EXPECT_TRUE(std::isinf(fits[0].misfit));
  EXPECT_FALSE(fits[0].fitsInOneWay());
}

TEST(EndDisagreements, endsThatFitInSeveralWaysSayNothing) {
  const EndFit paw{0, 1, 1.5, 0.1}, worse{0, 2, 3, 0.1};
  EXPECT_EQ(endDisagreements({{paw}, {worse}}), (std::vector<double>{0, 0}));
}

TEST(EndDisagreements, areSummedOverTheEndsAndOfOneNoMoreThanTwice) {
  const EndFit hand{0, 1, 3, 0}, other_hand{0, 1.5, 2, 0}, head{1, 1, 3, 0}, stump{1, 30, 40, 0};
  const std::vector<double> against = endDisagreements({{hand, stump}, {other_hand, head}});
  EXPECT_DOUBLE_EQ(against[0], std::log(2));
  EXPECT_DOUBLE_EQ(against[1], std::log(1.5));
}

TEST(EndDisagreements, whatIsNotKnownUnderAllMapsSaysNothing) {
  constexpr double UNKNOWN = std::numeric_limits<double>::infinity();
  const EndFit head{1, 1, 3, 0}, crumb{1, UNKNOWN, UNKNOWN, 0}, hand{0, 1, 3, 0}, worse{0, 2, 3, 0};
  EXPECT_EQ(endDisagreements({{head}, {crumb}}), (std::vector<double>{0, 0}));
  EXPECT_EQ(endDisagreements({{head}, {}}), (std::vector<double>{0, 0}));
  const std::vector<double> against = endDisagreements({{head, hand}, {worse}});
  EXPECT_EQ(against[0], 0);
  EXPECT_DOUBLE_EQ(against[1], std::log(2));
}

TEST(EndDisagreements, ofWhatFitsExactlyAreNone) {
  const EndFit exact{0, 0, 3, 0};
  EXPECT_EQ(endDisagreements({{exact}, {exact}}), (std::vector<double>{0, 0}));
}

TEST(EndDisagreements, doNotCountWhatIsByChance) {
  const EndFit fine{0, 0.01, 3, 1}, coarse{0, 0.1, 3, 1};
  const std::vector<double> against = endDisagreements({{fine}, {coarse}});
  EXPECT_NEAR(against[1], std::log(1.1 / 1.01), 1e-12);
}

TEST(EndDisagreements, ofNothingAreNothing) { EXPECT_TRUE(endDisagreements({}).empty()); }

/// Round about x, its triangles turned before it is drawn out.
SpectralSurface egg(double angle) {
  TriangleMesh mesh = test::sphere(4);
  mesh.vertices =
      mesh.vertices *
      Eigen::AngleAxisd(angle, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  mesh.vertices.col(0) *= 3;
  return test::spectralSurface(mesh, 10);
}

TEST(RigidEndsOfRoundBodies, sayNothing) {
  const SpectralSurface a = egg(0);
  // By 0.2 and 0.7 one way misfits by less than half of what any other does.
  for (double angle : {0.2, 0.7, 1.1}) {
    const SpectralSurface b = egg(angle);
    const VertexMaps maps{test::nearestOf(a.mesh.vertices, b.mesh),
                          test::nearestOf(b.mesh.vertices, a.mesh)};
    EXPECT_TRUE(rigidEnds(a, b, {test::tipOf(a.mesh)}, maps).empty()) << angle;
  }
}

}  // namespace
}  // namespace posture
