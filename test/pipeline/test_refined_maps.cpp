// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "refine/club.h"
#include "refined_maps.h"
#include <vector>

namespace posture {
namespace {

class RefinedMaps : public testing::Test {
 protected:
  RefinedMaps() : club_(givenSide("club", test::clubWithHand(), false)) {
    reduceSide(club_.full, club_);
    addSpectrum(club_);
    addSamples(club_);
  }

  /// The club onto itself, from a map that has the arm wound so.
  RefinedMap refined(double angle) const {
    const TriangleMesh& coarse = club_.coarse.mesh;
    Finalist finalist;
    finalist.maps = {test::nearestOf(test::wound(coarse, angle), coarse),
                     test::nearestOf(test::wound(coarse, -angle), coarse)};
    return refineFinalists(club_, club_, {&finalist}).front();
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
  EXPECT_LT(test::meanMiss(club_.work.mesh, map.pair.maps.forward), 0.3);
  EXPECT_LT(test::meanMiss(club_.work.mesh, map.pair.maps.backward), 0.3);
  EXPECT_GT(map.score.total(), scoreOf(map) + 0.03);
}

TEST(WorkMeshes, shareABudget) {
  RefinedShape light = givenSide("light", test::sphere(3), false),
               fine = givenSide("fine", test::sphere(5), false);
  const TriangleMesh all_of_light = light.full, all_of_fine = fine.full;
  reduceSide(all_of_fine, light);
  reduceSide(all_of_light, fine);
  EXPECT_EQ(light.work.mesh.vertices.rows(), 642);
  EXPECT_EQ(fine.work.mesh.vertices.rows(), 10000);
  reduceSide(all_of_fine, fine);
  EXPECT_EQ(fine.work.mesh.vertices.rows(), 5000);
  EXPECT_EQ(fine.coarse.mesh.vertices.rows(), 1500);
}

}  // namespace
}  // namespace posture
