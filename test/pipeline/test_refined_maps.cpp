// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/mesh/edges.h>

#include <gtest/gtest.h>

#include "refine/club.h"
#include "refined/refinement/refined_maps.h"
#include "support/shapes.h"
#include "support/unit_area.h"
#include <algorithm>
#include <cmath>
#include <vector>

namespace posture {
namespace {

RefinedShape refinedShape(const TriangleMesh& mesh) {
  RefinedShape shape = fullSide("club", mesh, false);
  reduceSide("source", 5000, shape);
  addSpectrum("side", shape);
  addSamples("body", shape);
  return shape;
}

class RefinedMaps : public testing::Test {
 protected:
  /// The club onto itself, from a map that has the arm wound so.
  static RefinedMap refined(double angle) {
    const TriangleMesh& coarse = club_.coarse.mesh;
    Finalist finalist;
    finalist.maps = {test::nearestOf(test::wound(coarse, angle), coarse),
                     test::nearestOf(test::wound(coarse, -angle), coarse)};
    RefinedMap map = refineFinalists(club_, club_, false, {&finalist}).front();
    annealMap(club_, club_, false, map);
    return map;
  }

  static double scoreOf(const RefinedMap& map) {
    const SpectralSurface work = club_.workSurface();
    return scoreMaps(work, work, map.pair.maps).total();
  }

  static const RefinedShape club_;
};

const RefinedShape RefinedMaps::club_ = refinedShape(test::clubWithHand());

TEST_F(RefinedMaps, whatFitsIsExact) {
  const RefinedMap map = refined(0);
  EXPECT_LT(test::meanMiss(club_.work.mesh, map.pair.maps.forward), 0.1);
  EXPECT_EQ(map.score.total(), scoreOf(map));
}

TEST_F(RefinedMaps, aTurnedHandIsTurnedBackAndJudgedAsBefore) {
  const RefinedMap map = refined(M_PI);
  // Turned wrongly it is off by more than an edge; the arm is nearly round, and held by little.
  EXPECT_LT(test::meanMiss(club_.work.mesh, map.pair.maps.forward), 0.5);
  EXPECT_LT(test::meanMiss(club_.work.mesh, map.pair.maps.backward), 0.5);
  EXPECT_GT(map.score.total(), scoreOf(map) + 0.03);
}

TEST_F(RefinedMaps, whatTheOtherSideLacksIsLetGoOfBeforeMapsAreCompared) {
  constexpr double CUT = 0.3;  // of an arm of about 0.9
  const RefinedShape cut = refinedShape(test::CutClub(club_.full, CUT).mesh);
  const TriangleMesh &a = club_.coarse.mesh, &b = cut.coarse.mesh;
  const test::SqueezedArm arm(club_.full, CUT);
  const Points onto = arm.squeezed(a.vertices), back = arm.drawnOut(b.vertices);
  Finalist finalist;
  finalist.maps = {test::nearestOf(onto, b), test::nearestOf(back, a)};
  finalist.bent = BentPair{finalist.maps, onto, back};
  const RefinedMap squeezed = refineFinalists(club_, cut, false, {&finalist}).front();
  const RefinedMap loose = refineFinalists(club_, cut, true, {&finalist}).front();
  // So much that it would not have been known for right.
  EXPECT_LT(loose.score.total(), squeezed.score.total() - 1);
  // In edges, of what both have.
  const auto miss = [&](const RefinedMap& map) {
    const TriangleMesh &whole = club_.work.mesh, &rest = cut.work.mesh;
    const double tip = whole.vertices.col(0).maxCoeff();
    double sum = 0;
    int count = 0;
    for (int v = 0; v < whole.vertices.rows(); ++v) {
      if (whole.vertices(v, 0) > tip - CUT) continue;
      sum += (whole.vertices.row(v) - rest.vertices.row(map.pair.maps.forward[v])).norm();
      ++count;
    }
    return sum / (count * meanEdgeLength(whole));
  };
  EXPECT_LT(miss(loose), 0.1);
  EXPECT_GT(miss(squeezed), 2 * miss(loose));
}

TEST_F(RefinedMaps, whatFitsIsLeftAsItIsThoughASideMayLackParts) {
  Finalist finalist;
  const Points& places = club_.coarse.mesh.vertices;
  finalist.maps = {test::nearestOf(places, club_.coarse.mesh),
                   test::nearestOf(places, club_.coarse.mesh)};
  const RefinedMap whole = refineFinalists(club_, club_, false, {&finalist}).front();
  const RefinedMap open = refineFinalists(club_, club_, true, {&finalist}).front();
  EXPECT_EQ(open.pair.maps.forward, whole.pair.maps.forward);
  EXPECT_TRUE(open.pair.apart_a.empty());
  EXPECT_EQ(open.score.total(), whole.score.total());
}

/// Two hands and a hump between them, on one side of the trunk or, half turned, on the other.
TriangleMesh humped(double height, bool turned) {
  TriangleMesh mesh = test::bodyWithTwoHands(3);
  const double side = turned ? -1 : 1, trunk = 0.1 * mesh.vertices.col(0).maxCoeff();
  for (auto p : mesh.vertices.rowwise()) {
    const double off = (p.x() - side * trunk) / trunk;
    if (side * p.z() > 0) p.z() *= 1 + height * std::exp(-off * off);
  }
  return mesh;
}

/// As they lie, and half turned: thumb on thumb, but each hand on the other one.
std::vector<Finalist> straightAndTurned(const RefinedShape& source, const RefinedShape& target) {
  const TriangleMesh &a = source.coarse.mesh, &b = target.coarse.mesh;
  const auto halfTurned = [](Points places) {
    places.col(0) *= -1;
    places.col(2) *= -1;
    return places;
  };
  std::vector<Finalist> finalists(2);
  finalists[0].maps = {test::nearestOf(a.vertices, b), test::nearestOf(b.vertices, a)};
  finalists[1].maps = {test::nearestOf(halfTurned(a.vertices), b),
                       test::nearestOf(halfTurned(b.vertices), a)};
  return finalists;
}

TEST(JudgedByEnds, handsTellWhetherABodyIsHalfTurned) {
  constexpr double HEIGHT = 0.42;  // the hump says one thing, the hands another
  const RefinedShape source = refinedShape(humped(HEIGHT, false)),
                     target = refinedShape(humped(HEIGHT, true));
  const std::vector<Finalist> finalists = straightAndTurned(source, target);
  const std::vector<RefinedMap> maps =
      refineFinalists(source, target, false, {&finalists[1], &finalists[0]});
  EXPECT_EQ(maps.front().finalist, 1);
  EXPECT_EQ(maps.front().ends, 0);
  const RefinedMap& turned = *std::find_if(
      maps.begin(), maps.end(), [](const RefinedMap& map) { return map.finalist == 0; });
  // By the rest of the body it would be the right one.
  EXPECT_LT(turned.score.total(), maps.front().score.total());
  EXPECT_GT(turned.ends, 0.5 * std::log(2));  // half of what one hand may cost
}

TEST(JudgedByEnds, aHalfTurnedBodyIsToldByItselfWhereASideMayLackParts) {
  TriangleMesh hollow = test::bodyWithTwoHands(3);
  hollow.vertices.col(2) *= 2;  // the palms, so that hands are not nearly their own mirror images
  const RefinedShape body = refinedShape(test::unitArea(hollow));
  const std::vector<Finalist> finalists = straightAndTurned(body, body);
  const auto refined = [&](bool turned, bool may_lack) {
    return refineFinalists(body, body, may_lack, {&finalists[turned ? 1 : 0]}).front();
  };
  const RefinedMap wrong = refined(true, true);
  EXPECT_GT(wrong.hands, 2);
  EXPECT_EQ(wrong.likeness(), wrong.score.total() + wrong.hands);
  EXPECT_EQ(refined(true, false).hands, 0);
  EXPECT_EQ(refined(false, true).hands, 0);
}

}  // namespace
}  // namespace posture
