// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/evaluation/map_error.h>
#include <posture/evaluation/statistics.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/shapes.h"
#include <algorithm>
#include <cmath>

namespace posture {
namespace {

constexpr int COLUMNS = 20, ROWS = 10;  // of unit squares: area 200

TriangleMesh plane() { return test::grid(COLUMNS, ROWS, COLUMNS, ROWS); }

int vertexAt(int column, int row) { return row * (COLUMNS + 1) + column; }

std::vector<VertexPair> identity(int n) {
  std::vector<VertexPair> pairs;
  for (int v = 0; v < n; ++v) pairs.push_back({v, v});
  return pairs;
}

std::vector<SurfacePoint> onVertices(const std::vector<int>& target_vertex) {
  std::vector<SurfacePoint> places(target_vertex.size());
  for (std::size_t v = 0; v < places.size(); ++v) places[v].vertex = target_vertex[v];
  return places;
}

std::vector<int> identityMap() {
  std::vector<int> map((COLUMNS + 1) * (ROWS + 1));
  for (std::size_t v = 0; v < map.size(); ++v) map[v] = static_cast<int>(v);
  return map;
}

/// Two columns to the right; the last two columns have no counterpart.
std::vector<int> shiftedMap() {
  std::vector<int> map = identityMap();
  for (int r = 0; r <= ROWS; ++r)
    for (int c = 0; c <= COLUMNS; ++c)
      map[vertexAt(c, r)] = c + 2 <= COLUMNS ? vertexAt(c + 2, r) : -1;
  return map;
}

std::vector<int> mirroredMap() {
  std::vector<int> map = identityMap();
  for (int r = 0; r <= ROWS; ++r)
    for (int c = 0; c <= COLUMNS; ++c) map[vertexAt(c, r)] = vertexAt(COLUMNS - c, r);
  return map;
}

TEST(MapError, identityHasNone) {
  const TargetMetric target(plane());
  const MapErrors errors =
      measureErrors(target, onVertices(identityMap()), identity(target.vertexCount()));
  EXPECT_EQ(errors.accepted, target.vertexCount());
  EXPECT_EQ(errors.relative_error.size(), static_cast<std::size_t>(target.vertexCount()));
  EXPECT_EQ(*std::max_element(errors.relative_error.begin(), errors.relative_error.end()), 0);
  EXPECT_THAT(edgeHistogram(errors), testing::ElementsAre(target.vertexCount()));
  EXPECT_EQ(shareWithinTwoEdges(errors), 1);
  EXPECT_THAT(errorCurve(errors), testing::Each(1.0));
}

TEST(MapError, shiftHasItsLength) {
  const TargetMetric target(plane());
  const MapErrors errors =
      measureErrors(target, onVertices(shiftedMap()), identity(target.vertexCount()));
  EXPECT_NEAR(mean(errors.relative_error), 2 / std::sqrt(200.0), 1e-3);
  EXPECT_NEAR(percentile(errors.relative_error, 0.5), 2 / std::sqrt(200.0), 1e-3);
  const int mapped = (COLUMNS - 1) * (ROWS + 1);
  EXPECT_THAT(edgeHistogram(errors), testing::ElementsAre(0, 0, mapped));
}

TEST(MapError, rejectedPointsCarryNone) {
  const TargetMetric target(plane());
  std::vector<int> map = identityMap();
  for (std::size_t v = 0; v < map.size(); v += 2) map[v] = -1;
  const MapErrors errors = measureErrors(target, onVertices(map), identity(target.vertexCount()));
  EXPECT_EQ(errors.source_vertices, target.vertexCount());
  EXPECT_EQ(errors.accepted, target.vertexCount() / 2);
  EXPECT_EQ(errors.true_pairs, target.vertexCount());
  EXPECT_EQ(errors.mapped_pairs, target.vertexCount() / 2);
  EXPECT_EQ(mean(errors.relative_error), 0);
  const double share = static_cast<double>(errors.mapped_pairs) / errors.true_pairs;
  EXPECT_NEAR(errorCurve(errors).front(), share, 1e-12);
  EXPECT_NEAR(errorCurve(errors).back(), share, 1e-12);
}

TEST(MapError, nothingMappedIsNoNumber) {
  const TargetMetric target(plane());
  const MapErrors errors = measureErrors(target,
                                         onVertices(std::vector<int>(target.vertexCount(), -1)),
                                         identity(target.vertexCount()));
  EXPECT_TRUE(std::isnan(mean(errors.relative_error)));
  EXPECT_TRUE(std::isnan(shareWithinTwoEdges(errors)));
  EXPECT_THAT(errorCurve(errors), testing::Each(0.0));
}

TEST(MapError, curveRisesToTheShareMapped) {
  const TargetMetric target(plane());
  std::vector<int> map = shiftedMap();
  for (std::size_t v = 0; v < map.size(); v += 3) map[v] = static_cast<int>(v);
  const MapErrors errors = measureErrors(target, onVertices(map), identity(target.vertexCount()));
  const std::vector<double> curve = errorCurve(errors);
  ASSERT_EQ(curve.size(), curvePlaces().size());
  EXPECT_DOUBLE_EQ(curvePlaces().back(), 0.25);
  EXPECT_TRUE(std::is_sorted(curve.begin(), curve.end()));
  EXPECT_NEAR(curve.back(), static_cast<double>(errors.mapped_pairs) / errors.true_pairs, 1e-12);
}

TEST(MapError, missesCountAsTheEndOfTheCurve) {
  const TargetMetric target(plane());
  const int n = target.vertexCount();
  const auto errorsOf = [&](const std::vector<int>& map) {
    return measureErrors(target, onVertices(map), identity(n));
  };
  EXPECT_EQ(meanWithMisses(errorsOf(identityMap())), 0);
  EXPECT_EQ(meanWithMisses(errorsOf(std::vector<int>(n, -1))), 0.25);
  EXPECT_TRUE(std::isnan(meanWithMisses(measureErrors(target, onVertices(identityMap()), {}))));
  // From one end to the other is as bad as no answer, and leaving the worst out gains nothing.
  const MapErrors far = errorsOf(std::vector<int>(n, 0));
  std::vector<int> near_alone(n, 0);
  for (int r = 0; r <= ROWS; ++r)
    for (int c = COLUMNS / 4; c <= COLUMNS; ++c) near_alone[vertexAt(c, r)] = -1;
  const MapErrors near = errorsOf(near_alone);
  EXPECT_LT(mean(near.relative_error), 0.7 * mean(far.relative_error));
  EXPECT_GE(meanWithMisses(near), meanWithMisses(far) - 1e-12);
  EXPECT_LE(meanWithMisses(far), 0.25);
  // The area above the curve.
  const MapErrors shifted = errorsOf(shiftedMap());
  double area = 0;
  for (double below : errorCurve(shifted)) area += (1 - below) * 0.25 / 100;
  EXPECT_NEAR(meanWithMisses(shifted), area, 0.25 / 100);
}

TEST(MapError, sparseTruthJudgesItsPairsOnly) {
  const TargetMetric target(plane());
  const MapErrors errors = measureErrors(target, onVertices(shiftedMap()), {{0, 0}, {5, 7}});
  EXPECT_EQ(errors.true_pairs, 2);
  ASSERT_EQ(errors.relative_error.size(), 2u);
  EXPECT_NEAR(errors.relative_error[0], 2 / std::sqrt(200.0), 1e-3);
  EXPECT_EQ(errors.relative_error[1], 0);
  EXPECT_THROW(measureErrors(target, onVertices(shiftedMap()), {{999, 0}}), std::invalid_argument);
}

TEST(MapError, measuresNoMoreThanTheWorkAllows) {
  const TargetMetric target(test::grid(44, 44, 44, 44));  // 2,025 vertices
  std::vector<int> turned(target.vertexCount());
  for (int v = 0; v < target.vertexCount(); ++v) turned[v] = target.vertexCount() - 1 - v;
  const auto truth = identity(target.vertexCount());
  const MapErrors all = measureErrors(target, onVertices(turned), truth);
  const MapErrors some = measureErrors(target, onVertices(turned), truth, 1'000'000);
  EXPECT_EQ(all.relative_error.size(), truth.size());
  EXPECT_LT(some.relative_error.size(), 3 * truth.size() / 4);
  EXPECT_GE(some.relative_error.size(), 1000u);
  EXPECT_NEAR(mean(some.relative_error), mean(all.relative_error), 0.01);
  // A good map costs little, so the same work measures all of it.
  std::vector<int> good(turned.rbegin(), turned.rend());
  EXPECT_EQ(measureErrors(target, onVertices(good), truth, 1'000'000).relative_error.size(),
            truth.size());
}

TEST(MapError, findsTheBestCandidate) {
  const TargetMetric target(plane());
  std::vector<int> lucky(target.vertexCount(), -1);
  for (int v = 0; v < 20; ++v) lucky[v * 11] = v * 11;
  const auto candidates =
      candidateErrors(target, {mirroredMap(), shiftedMap(), lucky}, identity(target.vertexCount()));
  ASSERT_EQ(candidates.size(), 3u);
  EXPECT_EQ(candidates[0].share_mapped, 1);
  EXPECT_NEAR(candidates[1].mean, 2 / std::sqrt(200.0), 1e-3);
  EXPECT_EQ(candidates[2].mean, 0);
  EXPECT_EQ(bestCandidate(candidates), 1);  // not the handful of lucky points
  EXPECT_TRUE(choseWrong(candidates[0], candidates[1]));
  EXPECT_FALSE(choseWrong(candidates[1], candidates[1]));
  EXPECT_FALSE(choseWrong({0.05, 1}, {0.035, 1}));  // a toss-up
  EXPECT_EQ(bestCandidate({{std::nan(""), 0}}), -1);
}

TEST(MapError, candidatesAreComparedOnASubset) {
  const TargetMetric target(plane());
  const auto truth = identity(target.vertexCount());
  const auto all = candidateErrors(target, {mirroredMap()}, truth);
  const auto some = candidateErrors(target, {mirroredMap()}, truth, 50);
  EXPECT_NE(all[0].mean, some[0].mean);
  EXPECT_NEAR(all[0].mean, some[0].mean, 0.1 * all[0].mean);
}

TEST(MapError, callsAMirroredMapMirrored) {
  const TargetMetric target(plane());
  const auto truth = identity(target.vertexCount());
  std::vector<VertexPair> mirror_truth;
  const std::vector<int> mirrored = mirroredMap();
  for (int v = 0; v < target.vertexCount(); ++v) mirror_truth.push_back({v, mirrored[v]});

  const auto wrong = compareWithMirror(target, onVertices(mirrored), truth, mirror_truth);
  EXPECT_TRUE(wrong.wrong_side);
  EXPECT_EQ(wrong.mean_to_mirror, 0);
  EXPECT_GT(wrong.mean_to_truth, 0.3);
  EXPECT_GT(wrong.share_nearer_mirror, 0.9);

  const auto right = compareWithMirror(target, onVertices(shiftedMap()), truth, mirror_truth, 100);
  EXPECT_FALSE(right.wrong_side);
  EXPECT_EQ(right.pairs, 100);
  EXPECT_NEAR(right.mean_to_truth, 2 / std::sqrt(200.0), 1e-3);

  const auto unknown = compareWithMirror(target, onVertices(mirrored), truth, {});
  EXPECT_EQ(unknown.pairs, 0);
  EXPECT_FALSE(unknown.wrong_side);
}

}  // namespace
}  // namespace posture
