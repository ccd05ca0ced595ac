// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/geodesic/landmarks.h>
#include <posture/mesh/edges.h>

#include <gtest/gtest.h>

#include "support/shapes.h"
#include <algorithm>
#include <limits>
#include <set>

namespace posture {
namespace {

/// All samples of a sphere, computed once.
struct SampledSphere {
  TriangleMesh mesh = test::sphere(3);
  Landmarks landmarks = computeLandmarks(mesh, FastMarching(mesh));
};

const SampledSphere& sampledSphere() {
  static const SampledSphere once;
  return once;
}

TEST(VoronoiSamples, coverTheSurfaceAndKeepApart) {
  const TriangleMesh sphere = test::sphere(4);
  const FastMarching marching(sphere);
  for (int most : {10, 100}) {
    const Landmarks landmarks = voronoiSamples(sphere, marching, most);
    ASSERT_EQ(landmarks.vertices.size(), most);
    std::vector<double> nearest(sphere.vertices.rows(), 1e9);
    double closest_pair = 1e9;
    GeodesicField field;
    for (int i = 0; i < most; ++i) {
      marching.march(landmarks.vertices[i], field);
      for (int v = 0; v < sphere.vertices.rows(); ++v)
        nearest[v] = std::min(nearest[v], field.distance[v]);
      for (int j = 0; j < i; ++j)
        closest_pair = std::min(closest_pair, field.distance[landmarks.vertices[j]]);
    }
    // Farthest-point sampling keeps samples as far apart as its covering radius. The bounded march
    // may miss a detour of the full one by a fraction of an edge.
    const double slack = 0.2 * meanEdgeLength(sphere);
    EXPECT_NEAR(
        *std::max_element(nearest.begin(), nearest.end()), landmarks.covering_radius, slack);
    EXPECT_GE(closest_pair, landmarks.covering_radius - slack);
  }
}

TEST(VoronoiSamples, areTheFarthestVerticesTheFirstOfSeveral) {
  // Two grids, full of equal distances, and a vertex in no face.
  const TriangleMesh grid = test::grid(24, 24, 1, 1);
  const int n = static_cast<int>(grid.vertices.rows());
  TriangleMesh loose = grid;
  loose.vertices.conservativeResize(n + 1, 3);
  loose.vertices.row(n) << 9, 9, 9;
  const TriangleMesh mesh = test::joined(loose, test::shifted(grid, {0, 0, 1}));

  const FastMarching marching(mesh);
  const Landmarks landmarks = voronoiSamples(mesh, marching, 200);
  ASSERT_EQ(landmarks.vertices.size(), 200);
  std::vector<double> distance(2 * n + 1, std::numeric_limits<double>::infinity());
  std::vector<int> nearest(2 * n + 1, -1);
  GeodesicField field;
  for (int i = 0; i < 200; ++i) {
    marching.marchWithin(landmarks.vertices[i], i, distance, nearest, field);
    distance[n] = -1;
    const auto farthest = std::max_element(distance.begin(), distance.end());
    if (i + 1 < 200) {
      ASSERT_EQ(landmarks.vertices[i + 1], farthest - distance.begin());
    } else {
      EXPECT_EQ(landmarks.covering_radius, *farthest);
    }
  }
  EXPECT_EQ(landmarks.nearest, nearest);
}

TEST(VoronoiSamples, stopAtTheResolutionOfTheMesh) {
  const TriangleMesh sphere = test::sphere(3);
  const Landmarks landmarks = voronoiSamples(sphere, FastMarching(sphere));
  EXPECT_LE(landmarks.covering_radius, meanEdgeLength(sphere));
  EXPECT_LT(landmarks.vertices.size(), sphere.vertices.rows());
  const std::set<int> distinct(landmarks.vertices.begin(), landmarks.vertices.end());
  EXPECT_EQ(distinct.size(), landmarks.vertices.size());
}

TEST(VoronoiSamples, endAtTheSpacingAskedForAndNoSooner) {
  const TriangleMesh sphere = test::sphere(4);
  const FastMarching marching(sphere);
  std::vector<int> finest;
  for (double spacing : {0.08, 0.2, 0.5, 1.5}) {
    const Landmarks samples = voronoiSamples(sphere, marching, 10000, spacing);
    const int count = static_cast<int>(samples.vertices.size());
    EXPECT_LE(samples.covering_radius, spacing);
    EXPECT_GT(voronoiSamples(sphere, marching, count - 1, 0).covering_radius, spacing);
    // Wherever it ends, the way there is the same.
    if (finest.empty()) finest = samples.vertices;
    EXPECT_TRUE(std::equal(samples.vertices.begin(), samples.vertices.end(), finest.begin()));
  }
  const Landmarks few = voronoiSamples(sphere, marching, 7, 0.08);
  EXPECT_EQ(few.vertices, std::vector<int>(finest.begin(), finest.begin() + 7));
}

TEST(VoronoiSamples, areAllVerticesInAFaceWhenNoSpacingIsAskedFor) {
  TriangleMesh grid = test::grid(12, 9, 4, 1);
  const int n = static_cast<int>(grid.vertices.rows());
  grid.vertices.conservativeResize(n + 1, 3);
  grid.vertices.row(n) << 9, 9, 9;  // in no face
  const FastMarching marching(grid);
  for (int most : {n, n + 1, 10 * n}) {
    const Landmarks samples = voronoiSamples(grid, marching, most, 0);
    EXPECT_EQ(samples.covering_radius, 0);
    ASSERT_EQ(samples.vertices.size(), static_cast<std::size_t>(n));
    for (int i = 0; i < n; ++i) EXPECT_EQ(samples.nearest[samples.vertices[i]], i);
    EXPECT_EQ(samples.nearest[n], -1);
  }
}

TEST(VoronoiSamples, eachVertexKnowsTheSampleNearestToIt) {
  const auto& [sphere, landmarks] = sampledSphere();
  const double slack = 0.2 * meanEdgeLength(sphere);
  for (int v = 0; v < sphere.vertices.rows(); ++v) {
    const float least = landmarks.distances.col(v).minCoeff();
    EXPECT_NEAR(landmarks.distances(landmarks.nearest[v], v), least, slack);
  }
}

TEST(Landmarks, distancesAreNearlySymmetric) {
  const auto& [sphere, landmarks] = sampledSphere();
  const Matrix mean = sampleDistances(landmarks);
  EXPECT_EQ((mean - mean.transpose()).norm(), 0);
  const double slack = 0.1 * meanEdgeLength(sphere);
  for (int i = 0; i < mean.rows(); ++i)
    for (int j = 0; j < mean.cols(); ++j)
      EXPECT_NEAR(mean(i, j), landmarks.distances(i, landmarks.vertices[j]), slack);
}

TEST(Landmarks, pathsOnAClosedSurfaceAreTrusted) {
  const auto& [sphere, landmarks] = sampledSphere();
  EXPECT_EQ(landmarks.confidence.minCoeff(), 1.0f);
}

TEST(Landmarks, whereThereIsNoPathNothingRunsAlongARim) {
  // Two sheets, whose paths within one another run along their rims.
  const TriangleMesh sheet = test::grid(8, 8, 1, 1);
  const TriangleMesh sheets = test::joined(sheet, test::shifted(sheet, {0, 0, 9}));
  const int n = static_cast<int>(sheet.vertices.rows());
  const Landmarks landmarks = computeLandmarks(sheets, FastMarching(sheets), 20);
  EXPECT_LT(landmarks.confidence.minCoeff(), 1.0f);
  for (std::size_t i = 0; i < landmarks.vertices.size(); ++i)
    for (std::size_t j = 0; j < landmarks.vertices.size(); ++j)
      if ((landmarks.vertices[i] < n) != (landmarks.vertices[j] < n)) {
        EXPECT_EQ(landmarks.confidence(i, j), 1.0f);
      }
}

TEST(Landmarks, pathsRoundAHoleAreTrustedByTheirShareOfItsRim) {
  // A long strip with a square hole in the middle: only what passes the hole runs along its rim.
  TriangleMesh strip = test::grid(60, 12, 5, 1);
  Faces kept(strip.faces.rows(), 3);
  int count = 0;
  for (int f = 0; f < strip.faces.rows(); ++f) {
    const double x = strip.vertices(strip.faces(f, 0), 0), y = strip.vertices(strip.faces(f, 0), 1);
    const double x2 = strip.vertices(strip.faces(f, 2), 0);
    const bool in_hole = std::min(x, x2) > 2.2 && std::max(x, x2) < 2.8 && y > 0.2 && y < 0.8;
    if (!in_hole) kept.row(count++) = strip.faces.row(f);
  }
  strip.faces = kept.topRows(count);
  const Landmarks landmarks = computeLandmarks(strip, FastMarching(strip));
  double across = 0, beside = 0;
  int across_count = 0, beside_count = 0;
  for (std::size_t i = 0; i < landmarks.vertices.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const Eigen::RowVector3d p = strip.vertices.row(landmarks.vertices[i]);
      const Eigen::RowVector3d q = strip.vertices.row(landmarks.vertices[j]);
      const bool inner = std::abs(p.y() - 0.5) < 0.3 && std::abs(q.y() - 0.5) < 0.3;
      if (!inner) continue;
      const float w = landmarks.confidence(i, j);
      EXPECT_GE(w, 0);
      EXPECT_LE(w, 1);
      if ((p.x() < 2 && q.x() > 3) || (p.x() > 3 && q.x() < 2)) {
        across += w;
        ++across_count;
      } else if ((p.x() < 2 && q.x() < 2) || (p.x() > 3 && q.x() > 3)) {
        beside += w;
        ++beside_count;
      }
    }
  ASSERT_GT(across_count, 10);
  ASSERT_GT(beside_count, 10);
  EXPECT_LT(across / across_count, 0.9);
  EXPECT_GT(beside / beside_count, 0.97);
}

}  // namespace
}  // namespace posture
