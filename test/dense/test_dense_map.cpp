// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/dense/dense_map.h>

#include <gtest/gtest.h>

#include "support/shapes.h"
#include <vector>

namespace posture {
namespace {

EmbeddedShape embed(const TriangleMesh& mesh) {
  EmbeddedShape shape{mesh, computeLandmarks(mesh, FastMarching(mesh)), {}};
  shape.form = computeCanonicalForm(shape.landmarks);
  return shape;
}

/// Every sample to itself.
Candidate identityCandidate(const EmbeddedShape& shape) {
  Candidate candidate;
  for (std::size_t i = 0; i < shape.landmarks.vertices.size(); ++i)
    candidate.matches.push_back({static_cast<int>(i), static_cast<int>(i)});
  return candidate;
}

std::vector<int> everyMatch(const Candidate& candidate) {
  std::vector<int> kernel(candidate.matches.size());
  for (std::size_t i = 0; i < kernel.size(); ++i) kernel[i] = static_cast<int>(i);
  return kernel;
}

TEST(DenseMap, ofAShapeToItselfIsTheIdentity) {
  const EmbeddedShape strip = embed(test::bentStrip(30, 8, 4, 1, 1));
  const Candidate candidate = identityCandidate(strip);
  const DenseMap map = computeDenseMap(strip, strip, candidate, everyMatch(candidate), 0.5);
  ASSERT_EQ(map.target_vertex.size(), 31 * 9);
  for (std::size_t v = 0; v < map.target_vertex.size(); ++v) {
    EXPECT_EQ(map.target_vertex[v], v);
    EXPECT_NEAR(map.confidence[v], 1, 1e-6);
  }
}

TEST(DenseMap, rejectsWhatTheMatchesDoNotAgreeWith) {
  // On the target everything lies twice as far apart: no vertex agrees with the farthest match.
  const EmbeddedShape strip = embed(test::bentStrip(30, 8, 4, 1, 1));
  EmbeddedShape large = strip;
  large.landmarks.distances *= 2;
  const Candidate candidate = identityCandidate(strip);
  const DenseMap map = computeDenseMap(strip, large, candidate, everyMatch(candidate), 0.6);
  for (std::size_t v = 0; v < map.target_vertex.size(); ++v) {
    EXPECT_EQ(map.target_vertex[v], -1);
    EXPECT_EQ(map.confidence[v], 0);
  }
}

TEST(DenseMap, withoutMatchesMapsNothing) {
  const EmbeddedShape strip = embed(test::bentStrip(20, 6, 3, 1, 1));
  const DenseMap map = computeDenseMap(strip, strip, {}, {}, 0.5);
  EXPECT_EQ(map.target_vertex, std::vector<int>(21 * 7, -1));
}

TEST(OneToOne, keepsTheSurestOfThoseThatShareATarget) {
  DenseMap map;
  map.target_vertex = {2, -1, 0, 2, 2, 5};
  map.confidence = Vector(6);
  map.confidence << 0.3, 0, 1, 0.9, 0.9, 0.1;
  const std::vector<VertexPair> pairs = oneToOne(map, 6);
  ASSERT_EQ(pairs.size(), 3u);
  const int source[] = {2, 3, 5}, target[] = {0, 2, 5};
  for (int k = 0; k < 3; ++k) {
    EXPECT_EQ(pairs[k].source, source[k]);
    EXPECT_EQ(pairs[k].target, target[k]);
  }
}

}  // namespace
}  // namespace posture
