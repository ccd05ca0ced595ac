// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/mesh/areas.h>
#include <posture/refine/partners.h>

#include <gtest/gtest.h>

#include "support/shapes.h"
#include <cmath>
#include <numeric>
#include <vector>

namespace posture {
namespace {

/// A sphere of area 1 mapped to itself, and a cap of it.
class WithoutPartner : public testing::Test {
 protected:
  static TriangleMesh unitSphere() {
    TriangleMesh mesh = test::sphere(3);
    mesh.vertices /= std::sqrt(surfaceArea(mesh));
    return mesh;
  }

  void SetUp() override {
    const Points& at = ball_.mesh.vertices;
    pair_.maps.forward.resize(at.rows());
    std::iota(pair_.maps.forward.begin(), pair_.maps.forward.end(), 0);
    pair_.maps.backward = pair_.maps.forward;
    pair_.bent_a = pair_.bent_b = at;
    for (const auto& p : at.rowwise()) cap_.push_back(p.z() > 0.25);
  }

  /// The vertices of the cap on the one opposite.
  void layOpposite() {
    const Points& at = ball_.mesh.vertices;
    for (Eigen::Index v = 0; v < at.rows(); ++v) {
      if (cap_[v] == 0) continue;
      Eigen::Index opposite = 0;
      (at.rowwise() + at.row(v)).rowwise().squaredNorm().minCoeff(&opposite);
      pair_.maps.forward[v] = static_cast<int>(opposite);
      pair_.bent_a.row(v) = at.row(opposite);
    }
  }

  std::vector<char> nothing() const { return std::vector<char>(cap_.size(), 0); }

  const BendableSurface ball_{unitSphere()};
  std::vector<char> cap_;
  BentPair pair_;
};

TEST_F(WithoutPartner, whatLiesWhereItBelongsHasOne) {
  pair_.apart_a = cap_;
  EXPECT_EQ(withoutPartner(ball_, ball_, pair_, {false, true}), nothing());
}

TEST_F(WithoutPartner, whatLiesOnAnotherPartHasNoneIfItsOwnMayBeMissing) {
  layOpposite();
  EXPECT_EQ(withoutPartner(ball_, ball_, pair_, {false, true}), cap_);
  EXPECT_EQ(withoutPartner(ball_, ball_, pair_, {false, false}), nothing());
}

TEST_F(WithoutPartner, onWhatHasNoCounterpartItselfItMayLie) {
  layOpposite();
  pair_.apart_b.assign(cap_.size(), 1);
  EXPECT_EQ(withoutPartner(ball_, ball_, pair_, {false, true}), nothing());
}

TEST_F(WithoutPartner, whatLiesFarFromItsMatchHasNone) {
  pair_.apart_a = cap_;
  for (std::size_t v = 0; v < cap_.size(); ++v)
    if (cap_[v] != 0) pair_.bent_a.row(static_cast<Eigen::Index>(v)) *= 1.5;
  EXPECT_EQ(withoutPartner(ball_, ball_, pair_, {}), cap_);
}

}  // namespace
}  // namespace posture
