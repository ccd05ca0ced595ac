// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "limb_pair.h"
#include "refine/club.h"
#include "refine/poses.h"
#include "support/shapes.h"
#include <algorithm>

namespace posture {
namespace {

constexpr double END = 0.15, BODY = 0.35;

/// A club onto another one, its hand turned over about an axis that is not the arm's.
class LimbPairTest : public testing::Test {
 protected:
  LimbPairTest() {
    pair_.bent_a = bentOver(club_, motion_);
    pair_.bent_b = bentOver(other_, motion_.inverse());
    pair_.maps = {test::nearestOf(pair_.bent_a, other_.mesh),
                  test::nearestOf(pair_.bent_b, club_.mesh)};
  }

  Points bentOver(const SpectralSurface& club, const Eigen::Isometry3d& motion) const {
    const std::vector<double>& distance = club.distances.from(test::tipOf(club.mesh));
    const Eigen::AngleAxisd turn(motion.linear());
    Points places = club.mesh.vertices;
    for (int v = 0; v < places.rows(); ++v) {
      const double share = std::clamp((BODY - distance[v]) / (BODY - END), 0.0, 1.0);
      const Eigen::Vector3d place = places.row(v).transpose();
      places.row(v) = (middle_ + Eigen::AngleAxisd(share * turn.angle(), turn.axis()).matrix() *
                                     (place - middle_))
                          .transpose();
    }
    return places;
  }

  BentPair annealed(const EndMove& move) const {
    const LimbPair limb(club_, other_, tip_, BODY + 0.1, softness_, pair_);
    EXPECT_TRUE(limb.isLimb());
    BentPair whole = pair_;
    limb.putInto(limb.annealed(move), whole);
    return whole;
  }

  const SpectralSurface club_ = test::spectralSurface(test::clubWithHand(0.8), 100),
                        other_ = test::spectralSurface(test::clubWithHand(0.6), 100);
  const int tip_ = test::tipOf(club_.mesh);
  const double softness_ = club_.eigenvalues[club_.eigenvalues.size() - 1];
  const Eigen::Vector3d middle_ = {club_.mesh.vertices.col(0).maxCoeff() - 0.1, 0, 0};
  const Eigen::Isometry3d motion_ =
      Eigen::Translation3d(middle_) *
      Eigen::AngleAxisd(3, Eigen::Vector3d(1, 0.3, 0.2).normalized()) *
      Eigen::Translation3d(-middle_);
  BentPair pair_;
};

TEST_F(LimbPairTest, anEndMovedBackFits) {
  EndMove back;
  back.of_a = motion_.inverse();
  back.of_b = motion_;
  back.end = END;
  back.body = BODY;
  const BentPair pair = annealed(back);
  EXPECT_LT(test::meanMiss(club_.mesh, pair.maps.forward), 0.5);
  EXPECT_LT(test::meanMiss(club_.mesh, pair.maps.backward), 0.5);
}

TEST_F(LimbPairTest, anEndLeftWhereItLiesDoesNot) {
  EndMove none;
  none.of_a = none.of_b = Eigen::Isometry3d::Identity();
  none.end = END;
  none.body = BODY;
  EXPECT_GT(test::meanMiss(club_.mesh, annealed(none).maps.forward), 1);
}

}  // namespace
}  // namespace posture
