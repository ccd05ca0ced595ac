// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/refine/tip_maps.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace posture {
namespace {

/// A limb leaves the trunk somewhere along it.
struct Limb {
  double root;  ///< share of the trunk's length
  double length;
  int thickness;  ///< samples at one place
};

/// Sticks with places every 0.02 along them, for which distances are known: those along the sticks.
class StickFigure {
 public:
  StickFigure(double trunk, const std::vector<Limb>& limbs) {
    constexpr double STEP = 0.02;
    for (int i = 0; i * STEP <= trunk; ++i)
      for (int copy = 0; copy < 3; ++copy) places_.push_back({i * STEP, -1, 0});
    for (int k = 0; k < static_cast<int>(limbs.size()); ++k) {
      const int count = static_cast<int>(std::round(limbs[k].length / STEP));
      for (int i = 1; i <= count; ++i)
        for (int copy = 0; copy < limbs[k].thickness; ++copy)
          places_.push_back({limbs[k].root * trunk, k, i * STEP});
      tips_.push_back(static_cast<int>(places_.size()) - limbs[k].thickness);
    }
  }

  /// The first sample at the end of each limb.
  const std::vector<int>& tips() const { return tips_; }

  /// How far sample i is out on limb k; 0 elsewhere.
  double out(int i, int k) const { return places_[i].limb == k ? places_[i].out : 0; }

  SampledShape shape() const {
    const auto n = static_cast<Eigen::Index>(places_.size());
    SampledShape shape;
    shape.distances.resize(n, n);
    for (Eigen::Index i = 0; i < n; ++i)
      for (Eigen::Index j = 0; j < n; ++j) {
        const Place &p = places_[i], &q = places_[j];
        shape.distances(i, j) = p.limb == q.limb && p.limb >= 0
                                    ? std::abs(p.out - q.out)
                                    : p.out + q.out + std::abs(p.along - q.along);
      }
    shape.confidence = Matrix::Ones(n, n);
    shape.spacing = 0.02;
    return shape;
  }

 private:
  struct Place {
    double along;
    int limb;
    double out;
  };
  std::vector<Place> places_;
  std::vector<int> tips_;
};

/// Head, tail, two front legs of one length, told apart by their thickness, and two hind legs of
/// one thickness, told apart by how far apart the tips are.
const std::vector<Limb> LIMBS{
    {1, 0.3, 6}, {0, 0.6, 1}, {0.9, 0.4, 2}, {0.9, 0.4, 4}, {0.1, 0.46, 2}, {0.1, 0.56, 2}};

TEST(TipMaps, findsTheEndsOfAllLimbs) {
  const StickFigure figure(0.5, LIMBS);
  std::vector<int> tips = tipsOf(figure.shape()), ends = figure.tips();
  std::sort(tips.begin(), tips.end());
  std::sort(ends.begin(), ends.end());
  EXPECT_EQ(tips, ends);
}

TEST(TipMaps, takesLimbsToLimbsOfABodyThatStretches) {
  // In another order, so that a tie is no help.
  const std::vector<Limb> reversed(LIMBS.rbegin(), LIMBS.rend());
  const StickFigure a(0.4, LIMBS), b(0.65, reversed);
  const std::vector<SampleMap> maps = tipMaps(a.shape(), b.shape(), 4);
  ASSERT_EQ(maps.size(), 4);
  const SampleMap& best = maps.front();
  for (std::size_t k = 0; k < LIMBS.size(); ++k) {
    const std::size_t partner = LIMBS.size() - 1 - k;
    EXPECT_NEAR(b.out(best.forward[a.tips()[k]], partner), LIMBS[k].length, 0.05) << k;
    EXPECT_NEAR(a.out(best.backward[b.tips()[partner]], k), LIMBS[k].length, 0.05) << k;
    // Half of a limb goes half of the way out.
    const int middle = a.tips()[k] - static_cast<int>(LIMBS[k].length / 0.04) * LIMBS[k].thickness;
    EXPECT_NEAR(b.out(best.forward[middle], partner), a.out(middle, k), 0.1) << k;
  }
}

TEST(TipMaps, findsAPartnerForMostWhereALimbIsMissing) {
  std::vector<Limb> five = LIMBS;
  five.erase(five.begin() + 2);
  const StickFigure a(0.5, five), b(0.5, LIMBS);
  const std::vector<SampleMap> maps = tipMaps(a.shape(), b.shape(), 1);
  ASSERT_EQ(maps.size(), 1);
  for (std::size_t k = 0; k < five.size(); ++k)
    EXPECT_GT(b.out(maps.front().forward[a.tips()[k]], k < 2 ? k : k + 1), 0.25) << k;
}

TEST(MapBetweenPlaces, takesWhatLiesBetweenThemToWhatLiesAlike) {
  const StickFigure a(0.5, LIMBS), b(0.65, LIMBS);
  const SampledShape shape_a = a.shape(), shape_b = b.shape();
  const SampleMap map = mapBetweenPlaces(shape_a,
                                         shape_a.distances(Eigen::all, a.tips()),
                                         shape_b,
                                         shape_b.distances(Eigen::all, b.tips()));
  for (std::size_t k = 0; k < LIMBS.size(); ++k) {
    EXPECT_NEAR(b.out(map.forward[a.tips()[k]], k), LIMBS[k].length, 0.05) << k;
    EXPECT_NEAR(a.out(map.backward[b.tips()[k]], k), LIMBS[k].length, 0.05) << k;
  }
  EXPECT_GT(map.distortion, 0);
}

TEST(TipMaps, saysNothingOfBodiesWithoutLimbs) {
  const StickFigure rod(1, {});
  EXPECT_TRUE(tipMaps(rod.shape(), rod.shape(), 4).empty());
  EXPECT_TRUE(tipMaps(rod.shape(), StickFigure(0.5, LIMBS).shape(), 4).empty());
}

}  // namespace
}  // namespace posture
