// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/mesh/edge_paths.h>

#include <gtest/gtest.h>

#include "support/shapes.h"
#include <limits>
#include <vector>

namespace posture {
namespace {

TEST(EdgePaths, areAsLongAsAGridsSides) {
  const TriangleMesh mesh = test::grid(10, 4, 10, 4);
  const EdgePaths paths(mesh);
  const Vector length = paths.lengths({0});
  for (int c = 0; c <= 10; ++c) EXPECT_NEAR(length[c], c, 1e-12);
  // From two ends at once the nearer one counts.
  EXPECT_NEAR(paths.lengths({0, 10})[7], 3, 1e-12);
}

TEST(EdgePaths, areInfiniteWhereNoWayLeads) {
  TriangleMesh two = test::grid(2, 1, 2, 1);
  two.faces.row(3) = two.faces.row(0);  // nothing is left at the last corner
  const EdgePaths paths(two);
  const int last = static_cast<int>(two.vertices.rows()) - 1;
  EXPECT_EQ(paths.lengths({0})[last], std::numeric_limits<double>::infinity());
  EXPECT_TRUE(paths.shortest(0, last).empty());
  EXPECT_FALSE(paths.reachesAll(0, {last}, std::numeric_limits<double>::infinity()));
}

TEST(EdgePaths, runOverAsManyEdgesAsTheirLengthSays) {
  const TriangleMesh mesh = test::sphere(3);
  const EdgePaths paths(mesh);
  const Vector length = paths.lengths({4});
  const std::vector<int> path = paths.shortest(4, 300);
  ASSERT_EQ(path.front(), 4);
  ASSERT_EQ(path.back(), 300);
  double sum = 0;
  for (std::size_t i = 1; i < path.size(); ++i)
    sum += (mesh.vertices.row(path[i]) - mesh.vertices.row(path[i - 1])).norm();
  EXPECT_NEAR(sum, length[300], 1e-12);
  EXPECT_EQ(paths.shortest(7, 7), std::vector<int>{7});
}

TEST(EdgePaths, reachWhatIsNotTooFar) {
  const TriangleMesh mesh = test::grid(10, 4, 10, 4);
  const EdgePaths paths(mesh);
  EXPECT_TRUE(paths.reachesAll(0, {3, 5, 0, 3}, 5));
  EXPECT_FALSE(paths.reachesAll(0, {3, 5}, 4.9));
  EXPECT_TRUE(paths.reachesAll(0, {}, 0));
}

}  // namespace
}  // namespace posture
