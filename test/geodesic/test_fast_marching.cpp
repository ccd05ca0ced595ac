// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/rng.h>
#include <posture/geodesic/fast_marching.h>
#include <posture/mesh/edges.h>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "support/shapes.h"
#include <cmath>
#include <limits>
#include <queue>

namespace posture {
namespace {

constexpr double PI = 3.14159265358979323846;

std::vector<double> distancesFrom(const TriangleMesh& mesh, int source) {
  GeodesicField field;
  FastMarching(mesh).march(source, field);
  return field.distance;
}

/// Mean absolute difference between marched distances and exact ones.
template <class Exact>
double meanError(const TriangleMesh& mesh, int source, const Exact& exact) {
  const std::vector<double> distance = distancesFrom(mesh, source);
  double sum = 0;
  for (int v = 0; v < mesh.vertices.rows(); ++v)
    sum += std::abs(distance[v] - exact(mesh.vertices.row(source), mesh.vertices.row(v)));
  return sum / static_cast<double>(mesh.vertices.rows());
}

double onSphere(const Eigen::RowVector3d& a, const Eigen::RowVector3d& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// Dijkstra along the edges: no geodesic is longer.
std::vector<double> alongEdges(const TriangleMesh& mesh, int source) {
  std::vector<std::vector<std::pair<int, double>>> joined(mesh.vertices.rows());
  for (const Edge& e : meshEdges(mesh.faces)) {
    const double length = (mesh.vertices.row(e.first) - mesh.vertices.row(e.second)).norm();
    joined[e.first].emplace_back(e.second, length);
    joined[e.second].emplace_back(e.first, length);
  }
  std::vector<double> distance(mesh.vertices.rows(), std::numeric_limits<double>::infinity());
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  distance[source] = 0;
  queue.emplace(0, source);
  while (!queue.empty()) {
    const auto [d, v] = queue.top();
    queue.pop();
    if (d > distance[v]) continue;
    for (const auto& [w, length] : joined[v])
      if (d + length < distance[w]) queue.emplace(distance[w] = d + length, w);
  }
  return distance;
}

TEST(FastMarching, isExactInThePlane) {
  const TriangleMesh plane = test::grid(20, 15, 2, 1.5);
  // Wedges are kept in single precision.
  for (int source : {0, 150, 335})
    EXPECT_LT(meanError(plane, source, [](const auto& a, const auto& b) { return (a - b).norm(); }),
              1e-6);
}

TEST(FastMarching, isExactInThePlaneOnObtuseTriangles) {
  // Sheared until most triangles have an obtuse corner, some of 150 degrees.
  TriangleMesh plane = test::grid(30, 30, 1, 1);
  plane.vertices.col(0) += 1.7 * plane.vertices.col(1);
  const int centre = 15 * 31 + 15;
  const auto straight = [](const auto& a, const auto& b) { return (a - b).norm(); };
  EXPECT_LT(meanError(plane, centre, straight), 2e-3);
}

TEST(FastMarching, convergesOnTheSphere) {
  double previous = std::numeric_limits<double>::infinity();
  for (int level : {2, 3, 4, 5}) {
    const TriangleMesh sphere = test::sphere(level);
    const double error = meanError(sphere, 0, onSphere);
    EXPECT_LT(error, 0.6 * previous) << "level " << level;  // first order: halved with the edges
    EXPECT_LT(error, 0.1 * meanEdgeLength(sphere)) << "level " << level;
    previous = error;
  }
}

TEST(FastMarching, doesNotNoticeThatAStripIsBent) {
  // A cylinder unrolls into the plane: distances are those of the flat strip.
  const TriangleMesh flat = test::grid(60, 10, 6, 1), bent = test::bentStrip(60, 10, 6, 1, PI);
  const std::vector<double> expected = distancesFrom(flat, 5 * 61),
                            found = distancesFrom(bent, 5 * 61);
  double largest = 0;
  for (std::size_t v = 0; v < found.size(); ++v)
    largest = std::max(largest, std::abs(found[v] - expected[v]));
  // Chords in place of arcs shorten a length L bent by PI in 60 steps by L (PI / 60)^2 / 24.
  EXPECT_LT(largest, 2 * 6 * std::pow(PI / 60, 2) / 24 + 1e-5);
}

TEST(FastMarching, liesBetweenTheStraightLineAndTheEdges) {
  for (const TriangleMesh& mesh : {test::sphere(3), test::bentStrip(40, 8, 4, 1, 4.0)}) {
    const int source = static_cast<int>(mesh.vertices.rows()) / 3;
    const std::vector<double> marched = distancesFrom(mesh, source),
                              edges = alongEdges(mesh, source);
    for (int v = 0; v < mesh.vertices.rows(); ++v) {
      EXPECT_LE(marched[v], edges[v] * (1 + 1e-6));
      EXPECT_GE(marched[v], (mesh.vertices.row(v) - mesh.vertices.row(source)).norm() * (1 - 1e-6));
    }
  }
}

TEST(FastMarching, goesRoundAHole) {
  // A square with a slit from the left side to x = 0.5 along y = 0.5: the ends of the left side
  // are joined round the slit's end.
  TriangleMesh square = test::grid(40, 40, 1, 1);
  Faces kept(square.faces.rows(), 3);
  int count = 0;
  for (int f = 0; f < square.faces.rows(); ++f) {
    const Eigen::RowVector3d centre =
        (square.vertices.row(square.faces(f, 0)) + square.vertices.row(square.faces(f, 1)) +
         square.vertices.row(square.faces(f, 2))) /
        3;
    if (centre.x() > 0.5 || std::abs(centre.y() - 0.5) > 0.025)
      kept.row(count++) = square.faces.row(f);
  }
  square.faces = kept.topRows(count);
  const std::vector<double> distance = distancesFrom(square, 0);
  const double exact = 2 * std::hypot(0.5, 0.475) + 0.05;
  EXPECT_NEAR(distance[40 * 41], exact, 0.01 * exact);
}

TEST(FastMarching, leavesOtherPartsUnreached) {
  TriangleMesh mesh = test::sphere(1);
  const int n = static_cast<int>(mesh.vertices.rows());
  mesh.vertices.conservativeResize(n + 1, 3);
  mesh.vertices.row(n) << 0, 0, 0;
  EXPECT_EQ(distancesFrom(mesh, 0)[n], std::numeric_limits<double>::infinity());
  EXPECT_EQ(distancesFrom(mesh, n)[0], std::numeric_limits<double>::infinity());
}

TEST(FastMarching, crossesNonManifoldEdges) {
  TriangleMesh fan;
  fan.vertices.resize(5, 3);
  fan.vertices << 0, 0, 0, 0, 1, 0, 1, 0, 0, -1, 0, 0, 0, 0, 1;
  fan.faces.resize(3, 3);
  fan.faces << 0, 2, 1, 0, 3, 1, 0, 4, 1;
  const std::vector<double> distance = distancesFrom(fan, 2);
  EXPECT_NEAR(distance[3], 2, 1e-6);
  EXPECT_NEAR(distance[4], 2, 1e-6);
}

TEST(FastMarching, survivesFacesWithoutArea) {
  TriangleMesh mesh = test::grid(6, 6, 1, 1);
  mesh.vertices.row(8) = 0.5 * (mesh.vertices.row(1) + mesh.vertices.row(2));
  mesh.vertices.row(16) = mesh.vertices.row(17);
  for (double d : distancesFrom(mesh, 0)) EXPECT_TRUE(std::isfinite(d));
}

TEST(FastMarching, reachesVerticesByIncreasingDistance) {
  for (int level : {2, 5}) {
    const TriangleMesh sphere = test::sphere(level);
    GeodesicField field;
    FastMarching(sphere).march(3, field);
    ASSERT_EQ(field.order.size(), sphere.vertices.rows());
    // Wedges are kept in single precision.
    for (std::size_t i = 1; i < field.order.size(); ++i)
      ASSERT_LE(field.distance[field.order[i - 1]] * (1 - 1e-6), field.distance[field.order[i]]);
  }
}

TEST(FastMarching, isNotDisturbedByOneLongEdge) {
  const TriangleMesh plane = test::grid(40, 40, 1, 1);
  const int n = static_cast<int>(plane.vertices.rows()), source = n / 2;
  const std::vector<double> expected = distancesFrom(plane, source);
  for (double length : {10.0, 1e4, 1e8}) {
    TriangleMesh spiked = plane;
    spiked.vertices.conservativeResize(n + 1, 3);
    spiked.vertices.row(n) << 0, -length, 0;
    spiked.faces.conservativeResize(spiked.faces.rows() + 1, 3);
    spiked.faces.bottomRows(1) << 1, 0, n;
    std::vector<double> found = distancesFrom(spiked, source);
    // Vertex 1 is the nearest place the spike can be entered at.
    EXPECT_NEAR(found[n], expected[1] + std::hypot(1.0 / 40, length), 1e-6 * length);
    found.pop_back();
    EXPECT_EQ(found, expected) << length;
  }
}

TEST(FastMarching, knowsNoUnit) {
  const TriangleMesh strip = test::bentStrip(40, 8, 4, 1, 4.0);
  const std::vector<double> expected = distancesFrom(strip, 0);
  for (int exponent : {-100, -20, 20, 100}) {
    TriangleMesh scaled = strip;
    scaled.vertices *= std::ldexp(1.0, exponent);
    const std::vector<double> found = distancesFrom(scaled, 0);
    for (std::size_t v = 0; v < found.size(); ++v)
      ASSERT_EQ(found[v], std::ldexp(expected[v], exponent)) << exponent;
  }
}

TEST(FastMarching, takesAFieldThatWasMarchedBefore) {
  const TriangleMesh sphere = test::sphere(3), strip = test::bentStrip(40, 8, 4, 1, 4.0);
  const FastMarching on_sphere(sphere), on_strip(strip);
  std::vector<double> cells(on_sphere.vertexCount(), 0.5);
  std::vector<int> nearest(on_sphere.vertexCount(), -1);
  GeodesicField again;
  const auto expectAsNew = [&](const FastMarching& marching, int source) {
    GeodesicField fresh;
    marching.march(source, fresh);
    marching.march(source, again);
    EXPECT_EQ(again.distance, fresh.distance);
    EXPECT_EQ(again.predecessor, fresh.predecessor);
    EXPECT_EQ(again.order, fresh.order);
  };
  expectAsNew(on_sphere, 5);
  expectAsNew(on_sphere, 600);
  expectAsNew(on_strip, 0);
  expectAsNew(on_sphere, 5);
  GeodesicField until;
  on_sphere.marchUntil(7, {12, 100}, until);
  for (int i = 0; i < 2; ++i) {
    on_sphere.marchUntil(7, {12, 100}, again);
    EXPECT_EQ(again.distance, until.distance);
  }
  expectAsNew(on_sphere, 7);
  on_sphere.marchWithin(9, 1, cells, nearest, again);
  expectAsNew(on_sphere, 9);
}

TEST(FastMarching, keepsToTheCell) {
  const TriangleMesh sphere = test::sphere(4);
  const FastMarching marching(sphere);
  GeodesicField first, cell;
  marching.march(0, first);
  std::vector<double> distance = first.distance;
  std::vector<int> nearest(marching.vertexCount(), 0);
  marching.marchWithin(100, 1, distance, nearest, cell);
  std::size_t count = 0;
  for (int v = 0; v < marching.vertexCount(); ++v) {
    EXPECT_LE(distance[v], first.distance[v]);
    EXPECT_EQ(nearest[v] == 1, distance[v] < first.distance[v]);
    EXPECT_EQ(cell.distance[v],
              nearest[v] == 1 ? distance[v] : std::numeric_limits<double>::infinity());
    EXPECT_TRUE(nearest[v] == 1 || cell.predecessor[v] == -1);
    count += nearest[v] == 1;
  }
  EXPECT_EQ(cell.order.size(), count);
  EXPECT_GT(count, 100);
  EXPECT_LT(count, marching.vertexCount() - 100);
}

TEST(FastMarching, stopsAtItsGoalsWithTheSameDistances) {
  const TriangleMesh sphere = test::sphere(4);
  const FastMarching marching(sphere);
  GeodesicField all, some;
  marching.march(7, all);
  const std::vector<int> goals{12, 100, 101};
  marching.marchUntil(7, goals, some);
  for (int goal : goals) EXPECT_EQ(some.distance[goal], all.distance[goal]);
  EXPECT_LE(some.order.size(), all.order.size());
  for (std::size_t i = 0; i < some.order.size(); ++i) EXPECT_EQ(some.order[i], all.order[i]);
  for (int v = 0; v < marching.vertexCount(); ++v)
    EXPECT_TRUE(some.distance[v] == all.distance[v] || std::isinf(some.distance[v]));
}

TEST(FastMarching, predecessorsLeadBackToTheSource) {
  const TriangleMesh sphere = test::sphere(3);
  GeodesicField field;
  FastMarching(sphere).march(5, field);
  for (int v = 0; v < sphere.vertices.rows(); ++v) {
    int steps = 0;
    for (int at = v; at != 5; at = field.predecessor[at]) {
      ASSERT_LT(field.distance[field.predecessor[at]], field.distance[at]);
      ASSERT_LT(++steps, 200);
    }
  }
}

TEST(FastMarching, refusesAVertexThatIsNotThere) {
  const FastMarching marching(test::sphere(0));
  GeodesicField field;
  EXPECT_THROW(marching.march(12, field), std::invalid_argument);
  EXPECT_THROW(marching.marchUntil(0, {-1}, field), std::invalid_argument);
}

}  // namespace
}  // namespace posture
