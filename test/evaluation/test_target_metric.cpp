// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/error.h>
#include <posture/evaluation/target_metric.h>
#include <posture/mesh/areas.h>

#include <gtest/gtest.h>

#include "support/shapes.h"
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <omp.h>
#include <stdexcept>

namespace posture {
namespace {

Route toVertex(int from, int to) {
  Route route;
  route.from = from;
  route.to.vertex = to;
  return route;
}

Route toFace(int from, int vertex, int face, const Eigen::Vector3d& barycentric) {
  return {from, {vertex, face, barycentric}};
}

/// All pairs of vertices, by Floyd and Warshall: nothing in common with a breadth-first search.
std::vector<std::vector<int>> allEdgeCounts(const TriangleMesh& mesh) {
  const int n = static_cast<int>(mesh.vertices.rows());
  std::vector<std::vector<int>> steps(n, std::vector<int>(n, n));
  for (int v = 0; v < n; ++v) steps[v][v] = 0;
  for (int f = 0; f < mesh.faces.rows(); ++f)
    for (int k = 0; k < 3; ++k) {
      const int a = mesh.faces(f, k), b = mesh.faces(f, (k + 1) % 3);
      steps[a][b] = steps[b][a] = 1;
    }
  for (int via = 0; via < n; ++via)
    for (int a = 0; a < n; ++a)
      for (int b = 0; b < n; ++b)
        steps[a][b] = std::min(steps[a][b], steps[a][via] + steps[via][b]);
  return steps;
}

/// A 10 x 10 grid of unit squares with a small triangle floating `height` above vertex 60.
TriangleMesh gridWithLoosePart(double height) {
  TriangleMesh mesh = test::grid(10, 10, 10, 10);
  const Eigen::RowVector3d center = mesh.vertices.row(60);
  mesh.vertices.conservativeResize(124, 3);
  mesh.vertices.row(121) = center + Eigen::RowVector3d(0, 0, height);
  mesh.vertices.row(122) = center + Eigen::RowVector3d(0.1, 0, height);
  mesh.vertices.row(123) = center + Eigen::RowVector3d(0, 0.1, height);
  mesh.faces.conservativeResize(201, 3);
  mesh.faces.row(200) << 121, 122, 123;
  return mesh;
}

TEST(TargetMetric, measuresAcrossASeamThatRoundingOpened) {
  const TriangleMesh half = test::grid(10, 10, 10, 10);
  const auto n = half.vertices.rows();
  const TargetMetric metric(test::joined(half, test::shifted(half, {10 + 1e-6, 0, 0})));
  Eigen::Index left = 0, right = 0;
  (half.vertices.col(0) + half.vertices.col(1)).minCoeff(&left);
  (half.vertices.col(0) - half.vertices.col(1)).maxCoeff(&right);
  // From one lower corner to the other one.
  const Route across = toVertex(static_cast<int>(left), static_cast<int>(n + right));
  EXPECT_NEAR(metric.geodesics({across}).length[0], 20, 1e-3);
  EXPECT_EQ(metric.edgeCounts({across})[0], 20);
}

TEST(TargetMetric, refusesAFaceOfNoVertex) {
  TriangleMesh mesh = test::grid(2, 2, 2, 2);
  mesh.faces(0, 0) = 1000;
  EXPECT_THROW(TargetMetric{mesh}, std::invalid_argument);
}

TEST(TargetMetric, measuresThePlane) {
  const TriangleMesh mesh = test::grid(10, 20, 5, 10);
  const TargetMetric metric(mesh);
  EXPECT_NEAR(metric.rootArea(), std::sqrt(50.0), 1e-12);
  const auto lengths = metric.geodesics({toVertex(0, 10), toVertex(0, 220), toVertex(7, 7)}).length;
  EXPECT_NEAR(lengths[0], 5, 0.01);
  EXPECT_NEAR(lengths[1], 10, 0.01);
  EXPECT_EQ(lengths[2], 0);
}

TEST(TargetMetric, reachesPlacesInsideFaces) {
  const TriangleMesh mesh = test::grid(10, 10, 10, 10);
  const TargetMetric metric(mesh);
  // Face 0 is (0, 1, 12): its middle is at (2/3, 1/3).
  const Eigen::Vector3d middle = Eigen::Vector3d::Constant(1.0 / 3);
  const auto lengths = metric
                           .geodesics({toFace(0, 0, 0, middle),
                                       toFace(10, 0, 0, middle),
                                       toFace(0, 1, 0, {0.25, 0.75, 0}),
                                       toFace(1, 1, 0, {0, 1, 0})})
                           .length;
  EXPECT_NEAR(lengths[0], std::hypot(2.0 / 3, 1.0 / 3), 1e-12);  // straight within the face
  EXPECT_NEAR(lengths[1], std::hypot(10 - 2.0 / 3, 1.0 / 3), 0.02);
  EXPECT_NEAR(lengths[2], 0.75, 1e-12);
  EXPECT_NEAR(lengths[3], 0, 1e-12);
}

TEST(TargetMetric, loosePartsFollowTheSurface) {
  const TargetMetric metric(gridWithLoosePart(0.5));
  EXPECT_NEAR(metric.rootArea(), 10, 1e-12);
  const std::vector<Route> routes{
      toVertex(121, 60), toVertex(121, 65), toVertex(65, 121), toVertex(121, 121)};
  const auto lengths = metric.geodesics(routes).length;
  EXPECT_NEAR(lengths[0], 0.5, 1e-6);
  EXPECT_NEAR(lengths[1], 5.5, 0.01);
  EXPECT_NEAR(lengths[2], 5.5, 0.01);
  EXPECT_EQ(lengths[3], 0);
  EXPECT_EQ(metric.edgeCounts(routes), (std::vector<int>{1, 6, 6, 0}));
}

TEST(TargetMetric, duplicateVerticesAreOnePlace) {
  TriangleMesh mesh = test::grid(4, 4, 4, 4);
  mesh.vertices.conservativeResize(26, 3);
  mesh.vertices.row(25) = mesh.vertices.row(12);
  const TargetMetric metric(mesh);
  EXPECT_NEAR(metric.geodesics({toVertex(12, 25)}).length[0], 0, 1e-12);
  EXPECT_EQ(metric.edgeCounts({toVertex(12, 25)})[0], 0);
}

TEST(TargetMetric, countsEdgesLikeFloydAndWarshall) {
  const TriangleMesh mesh = test::grid(9, 7, 9, 7);
  const TargetMetric metric(mesh);
  const auto expected = allEdgeCounts(mesh);
  std::vector<Route> routes;
  for (int a = 0; a < metric.vertexCount(); ++a)
    for (int b = 0; b < metric.vertexCount(); b += 3) routes.push_back(toVertex(a, b));
  const std::vector<int> counts = metric.edgeCounts(routes);
  for (std::size_t r = 0; r < routes.size(); ++r)
    ASSERT_EQ(counts[r], expected[routes[r].from][routes[r].to.vertex]);
}

TEST(TargetMetric, sameWithOneThreadAndMany) {
  const TriangleMesh mesh = test::sphere(3);
  const TargetMetric metric(mesh);
  std::vector<Route> routes;
  for (int a = 0; a < metric.vertexCount(); ++a)
    routes.push_back(toVertex(a, (a * 37 + 11) % metric.vertexCount()));
  const int threads = omp_get_max_threads();
  omp_set_num_threads(1);
  const RouteLengths one = metric.geodesics(routes);
  omp_set_num_threads(4);
  const RouteLengths many = metric.geodesics(routes);
  omp_set_num_threads(threads);
  EXPECT_EQ(one.length, many.length);
  EXPECT_EQ(one.settled_vertices, many.settled_vertices);
}

TEST(TargetMetric, refusesWhatIsNotThere) {
  const TargetMetric metric(test::grid(2, 2, 1, 1));
  EXPECT_THROW(metric.geodesics({toVertex(9, 0)}), std::invalid_argument);
  EXPECT_THROW(metric.geodesics({toVertex(0, -1)}), std::invalid_argument);
  EXPECT_THROW(metric.edgeCounts({toFace(0, 0, 8, {1, 0, 0})}), std::invalid_argument);
  EXPECT_THROW(TargetMetric({Points::Zero(3, 3), Faces(0, 3)}), InputError);
}

}  // namespace
}  // namespace posture
