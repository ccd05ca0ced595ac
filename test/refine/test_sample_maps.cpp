// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/rng.h>
#include <posture/refine/sample_maps.h>

#include <gtest/gtest.h>

#include "refine/poses.h"
#include "support/shapes.h"
#include <algorithm>
#include <cmath>
#include <numeric>

namespace posture {
namespace {

constexpr int SAMPLES = 150;

int sampleCount(const SampledShape& shape) { return static_cast<int>(shape.form.rows()); }

SampleMap identityOf(const SampledShape& shape) {
  SampleMap map;
  map.forward.resize(sampleCount(shape));
  std::iota(map.forward.begin(), map.forward.end(), 0);
  map.backward = map.forward;
  return map;
}

/// The sample map that comes nearest to a map of the vertices.
SampleMap sampleMapOf(const VertexMaps& maps, const test::Samples& a, const test::Samples& b) {
  SampleMap map;
  for (int v : a.landmarks.vertices) map.forward.push_back(b.landmarks.nearest[maps.forward[v]]);
  for (int v : b.landmarks.vertices) map.backward.push_back(a.landmarks.nearest[maps.backward[v]]);
  return map;
}

/// How far apart two maps are on the target, in the mean, in spacings of its samples.
double gap(const SampledShape& b, const std::vector<int>& x, const std::vector<int>& y) {
  double sum = 0;
  for (std::size_t i = 0; i < x.size(); ++i) sum += b.distances(x[i], y[i]);
  return sum / static_cast<double>(x.size()) / b.spacing;
}

/// Distances and confidence alone.
SampledShape randomShape(int count, std::uint64_t seed) {
  SampledShape shape;
  shape.form = test::randomPoints(count, seed);
  shape.distances = test::pairwise(shape.form);
  const Points more = test::randomPoints(count, seed + 100);
  shape.confidence = (-test::pairwise(more)).array().exp();
  return shape;
}

SampleMap randomMap(const SampledShape& a, const SampledShape& b, std::uint64_t seed) {
  Rng rng(seed);
  SampleMap map;
  for (int i = 0; i < sampleCount(a); ++i) map.forward.push_back(rng.below(sampleCount(b)));
  for (int i = 0; i < sampleCount(b); ++i) map.backward.push_back(rng.below(sampleCount(a)));
  return map;
}

/// Two poses of an animal with their samples.
class Animal : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    poses = &test::poses(BodyKind::QUADRUPED);
    a = new test::Samples(poses->a, SAMPLES);
    b = new test::Samples(poses->b, SAMPLES);
  }
  static void TearDownTestSuite() {
    delete b;
    delete a;
  }

  static SampleMap truth() { return sampleMapOf(test::identity(poses->a), *a, *b); }

  static inline const test::Poses* poses = nullptr;
  static inline const test::Samples* a = nullptr;
  static inline const test::Samples* b = nullptr;
};

TEST(Distortion, isZeroForTheIdentity) {
  const SampledShape shape = randomShape(30, 1);
  EXPECT_EQ(distortion(shape, shape, identityOf(shape)), 0);
}

TEST(Distortion, isTheMeanChangeOverTheMeanDistance) {
  const SampledShape a = randomShape(20, 1), b = randomShape(30, 2);
  const SampleMap map = randomMap(a, b, 3);
  const auto oneWay = [](const SampledShape& from, const SampledShape& to, const auto& images) {
    double change = 0, length = 0;
    for (int i = 0; i < sampleCount(from); ++i)
      for (int j = 0; j < sampleCount(from); ++j) {
        if (i == j) continue;
        const double w = from.confidence(i, j) * to.confidence(images[i], images[j]);
        change += w * std::abs(from.distances(i, j) - to.distances(images[i], images[j]));
        length += w * from.distances(i, j);
      }
    return change / length;
  };
  const double expected = (oneWay(a, b, map.forward) + oneWay(b, a, map.backward)) / 2;
  EXPECT_NEAR(distortion(a, b, map), expected, 1e-12);
}

TEST(Distortion, isTheSameBothWays) {
  const SampledShape a = randomShape(20, 1), b = randomShape(30, 2);
  const SampleMap map = randomMap(a, b, 4);
  EXPECT_DOUBLE_EQ(distortion(a, b, map), distortion(b, a, {map.backward, map.forward, 0}));
}

TEST(Distortion, ofGrowthIsItsShare) {
  const SampledShape a = randomShape(20, 1);
  SampledShape b = a;
  b.distances *= 1.2;
  EXPECT_NEAR(distortion(a, b, identityOf(a)), (0.2 + 0.2 / 1.2) / 2, 1e-12);
}

TEST(Distortion, doesNotSeeWhatIsNotTrusted) {
  SampledShape a = randomShape(20, 1);
  SampledShape b = a;
  a.confidence(3, 7) = a.confidence(7, 3) = 0;
  b.distances(3, 7) = b.distances(7, 3) = 99;
  b.distances(4, 9) = b.distances(9, 4) = 99;
  b.confidence(4, 9) = b.confidence(9, 4) = 0;
  EXPECT_EQ(distortion(a, b, identityOf(a)), 0);
  a.confidence.setZero();
  EXPECT_EQ(distortion(a, b, identityOf(a)), 1);
}

TEST_F(Animal, zoomOutKeepsTheIdentity) {
  SampleMap map = identityOf(a->shape);
  zoomOut(a->shape, a->shape, {10, 20, 36}, map);
  EXPECT_EQ(map.forward, identityOf(a->shape).forward);
  EXPECT_EQ(map.backward, identityOf(a->shape).backward);
}

TEST_F(Animal, zoomOutDoesNotDependOnTheBasis) {
  // Other functions that span the same, mixed by any rotation.
  const int k = 20;
  SampledShape mixed = a->shape;
  mixed.functions.leftCols(k) *= test::randomRotation(k, 1).cast<float>();
  SampleMap map = identityOf(a->shape);
  zoomOut(a->shape, mixed, {k}, map);
  EXPECT_EQ(map.forward, identityOf(a->shape).forward);
  EXPECT_EQ(map.backward, identityOf(a->shape).backward);
}

TEST_F(Animal, zoomOutMendsAPerturbedMap) {
  SampleMap map = truth();
  Rng rng(1);
  for (int i = 0; i < SAMPLES / 3; ++i) {  // about a third of the matches to anywhere
    map.forward[rng.below(SAMPLES)] = rng.below(SAMPLES);
    map.backward[rng.below(SAMPLES)] = rng.below(SAMPLES);
  }
  const double gap_before = gap(b->shape, map.forward, truth().forward);
  const double distortion_before = distortion(a->shape, b->shape, map);
  zoomOut(a->shape, b->shape, {4, 8, 12, 16, 20, 24, 28, 32, 36}, map);
  EXPECT_GT(gap_before, 1.5);
  EXPECT_LT(gap(b->shape, map.forward, truth().forward), 0.7);
  EXPECT_LT(gap(a->shape, map.backward, truth().backward), 0.7);
  EXPECT_LT(distortion(a->shape, b->shape, map), 0.5 * distortion_before);
}

TEST_F(Animal, zoomOutTakesNoMoreFunctionsThanThereAre) {
  SampleMap most = truth(), more = truth();
  const int available = static_cast<int>(a->shape.functions.cols());
  zoomOut(a->shape, b->shape, {available}, most);
  zoomOut(a->shape, b->shape, {10 * available}, more);
  EXPECT_EQ(most.forward, more.forward);
}

TEST_F(Animal, thePoolOfAShapeWithItselfBeginsWithTheIdentity) {
  const std::vector<SampleMap> pool = poolOfMaps(a->shape, a->shape, 16);
  ASSERT_FALSE(pool.empty());
  EXPECT_LT(gap(a->shape, pool.front().forward, identityOf(a->shape).forward), 1);
  EXPECT_LT(gap(a->shape, pool.front().backward, identityOf(a->shape).backward), 1);
}

TEST_F(Animal, thePoolIsDistinctAndInOrder) {
  const std::vector<SampleMap> pool = poolOfMaps(a->shape, b->shape, 12);
  ASSERT_EQ(pool.size(), 12u);
  for (std::size_t i = 0; i < pool.size(); ++i) {
    EXPECT_NEAR(pool[i].distortion, distortion(a->shape, b->shape, pool[i]), 1e-12);
    ASSERT_EQ(pool[i].forward.size(), static_cast<std::size_t>(SAMPLES));
    ASSERT_EQ(pool[i].backward.size(), static_cast<std::size_t>(SAMPLES));
    for (std::size_t j = 0; j < i; ++j) {
      EXPECT_LE(pool[j].distortion, pool[i].distortion);
      EXPECT_GE(gap(b->shape, pool[i].forward, pool[j].forward), 1);
    }
  }
}

TEST_F(Animal, thePoolHasTheRightMapAndTheMirroredOne) {
  // An animal is all but its own mirror image: distances alone cannot tell.
  const SampleMap wrong = sampleMapOf(test::mirrored(*poses), *a, *b);
  double nearest_right = 1e9, nearest_wrong = 1e9;
  for (const SampleMap& map : poolOfMaps(a->shape, b->shape, 16)) {
    nearest_right = std::min(nearest_right, gap(b->shape, map.forward, truth().forward));
    nearest_wrong = std::min(nearest_wrong, gap(b->shape, map.forward, wrong.forward));
  }
  EXPECT_LT(nearest_right, 1);
  EXPECT_LT(nearest_wrong, 1);
  EXPECT_GT(gap(b->shape, truth().forward, wrong.forward), 2);
}

TEST_F(Animal, thePoolDoesNotDependOnSigns) {
  SampledShape turned = b->shape;
  turned.form.col(0) *= -1;
  turned.form.col(2) *= -1;
  for (int k : {1, 2, 5, 8}) turned.functions.col(k) *= -1;
  const double best = poolOfMaps(a->shape, b->shape, 4).front().distortion;
  EXPECT_NEAR(poolOfMaps(a->shape, turned, 4).front().distortion, best, 0.05 * best);
}

TEST_F(Animal, thePoolTakesShapesOfDifferentSampleCounts) {
  const test::Samples few(poses->b, 90);
  const std::vector<SampleMap> pool = poolOfMaps(a->shape, few.shape, 8);
  const SampleMap right = sampleMapOf(test::identity(poses->a), *a, few);
  double nearest = 1e9;
  for (const SampleMap& map : pool) {
    ASSERT_EQ(map.forward.size(), static_cast<std::size_t>(SAMPLES));
    ASSERT_EQ(map.backward.size(), 90u);
    nearest = std::min(nearest, gap(few.shape, map.forward, right.forward));
  }
  EXPECT_LT(nearest, 1);
}

}  // namespace
}  // namespace posture
