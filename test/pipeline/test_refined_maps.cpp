// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "refine/club.h"
#include "refined_maps.h"
#include "support/shapes.h"
#include <cmath>
#include <vector>

namespace posture {
namespace {

class RefinedMaps : public testing::Test {
 protected:
  RefinedMaps() : club_(fullSide("club", test::clubWithHand(), false)) {
    reduceSide(5000, club_);
    addSpectrum(club_);
    addSamples(club_);
  }

  /// The club onto itself, from a map that has the arm wound so.
  RefinedMap refined(double angle) const {
    const TriangleMesh& coarse = club_.coarse.mesh;
    Finalist finalist;
    finalist.maps = {test::nearestOf(test::wound(coarse, angle), coarse),
                     test::nearestOf(test::wound(coarse, -angle), coarse)};
    RefinedMap map = refineFinalists(club_, club_, {&finalist}).front();
    annealMap(club_, club_, false, map);
    return map;
  }

  double scoreOf(const RefinedMap& map) const {
    const SpectralSurface work = club_.workSurface();
    return scoreMaps(work, work, map.pair.maps).total();
  }

  RefinedShape club_;
};

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

TEST(WorkMeshes, shareABudget) {
  RefinedShape light = fullSide("light", test::sphere(3), false),
               fine = fullSide("fine", test::sphere(5), false);
  reduceSide(10242, light);
  reduceSide(642, fine);
  EXPECT_EQ(light.work.mesh.vertices.rows(), 642);
  EXPECT_EQ(fine.work.mesh.vertices.rows(), 10000);
  reduceSide(4000, fine);
  EXPECT_EQ(fine.work.mesh.vertices.rows(), 6250);
  reduceSide(10242, fine);
  EXPECT_EQ(fine.work.mesh.vertices.rows(), 5000);
  EXPECT_EQ(fine.coarse.mesh.vertices.rows(), 1500);
}

}  // namespace
}  // namespace posture
