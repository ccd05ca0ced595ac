// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/mesh/areas.h>
#include <posture/mesh/edges.h>

#include <gtest/gtest.h>

#include "refined/refinement/full_resolution.h"
#include "support/bodies.h"
#include <cmath>

namespace posture {
namespace {

/// With so few work vertices that there are that many levels of at most twelve times the vertices.
RefinedShape person(int pose, int work_vertices) {
  RefinedShape shape = fullSide("person", test::person(pose).mesh, false);
  shape.work = reduceMesh(shape.full, work_vertices);
  // About the 200th eigenvalue of a surface of that area (Weyl's law).
  const double area = faceAreas(shape.full).sum();
  shape.basis.eigenvalues = Vector::Constant(1, 200 * 4 * M_PI / area);
  return shape;
}

/// Between bodies of the same numbering: each vertex to that of the other work mesh nearest to it.
RefinedMap trueMap(const RefinedShape& a, const RefinedShape& b) {
  RefinedMap map;
  for (int v : a.work.vertex) map.pair.maps.forward.push_back(b.work.nearest[v]);
  for (int v : b.work.vertex) map.pair.maps.backward.push_back(a.work.nearest[v]);
  map.pair.bent_a = b.full.vertices(a.work.vertex, Eigen::all);
  map.pair.bent_b = a.full.vertices(b.work.vertex, Eigen::all);
  return map;
}

double meanMissInEdges(const TriangleMesh& mesh, const std::vector<int>& map) {
  double sum = 0;
  for (int v = 0; v < mesh.vertices.rows(); ++v)
    sum += (mesh.vertices.row(map[v]) - mesh.vertices.row(v)).norm();
  return sum / static_cast<double>(map.size()) / meanEdgeLength(mesh);
}

class FullResolution : public testing::TestWithParam<int> {};

TEST_P(FullResolution, isReachedFromFewVertices) {
  const RefinedShape a = person(0, GetParam()), b = person(1, GetParam());
  ASSERT_EQ(levelsBetween(a), GetParam() < 200 ? 1 : 0);
  const FullMap map = toFullResolution(a, b, trueMap(a, b));
  ASSERT_EQ(map.places.size(), static_cast<std::size_t>(a.full.vertices.rows()));
  EXPECT_LT(meanMissInEdges(b.full, map.pair.maps.forward), 0.5);
  EXPECT_LT(meanMissInEdges(a.full, map.pair.maps.backward), 0.5);
  const FullMap back = reversed(a, b, map);
  EXPECT_EQ(back.pair.maps.forward, map.pair.maps.backward);
  EXPECT_EQ(back.places.size(), static_cast<std::size_t>(b.full.vertices.rows()));
}

// Of about 2,500 vertices: without a level in between, and with one.
INSTANTIATE_TEST_SUITE_P(WorkVertices, FullResolution, testing::Values(600, 150));

}  // namespace
}  // namespace posture
