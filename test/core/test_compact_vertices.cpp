// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/compact_vertices.h>
#include <posture/core/rng.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

namespace posture {
namespace {

/// Faces that leave many of the vertices out.
Faces scattered(int faces, int vertices) {
  Rng rng(5);
  Faces some(faces, 3);
  for (int& v : some.reshaped()) v = rng.below(vertices);
  return some;
}

TEST(CompactVertices, keepTheirOrder) {
  const Faces before = scattered(30, 200);
  Faces after = before;
  const std::vector<int> kept = compactVertices(after, 200);
  const std::set<int> used(before.data(), before.data() + before.size());
  EXPECT_EQ(kept, std::vector<int>(used.begin(), used.end()));
  for (Eigen::Index i = 0; i < before.size(); ++i)
    EXPECT_EQ(kept[after.data()[i]], before.data()[i]);
}

TEST(CompactVertices, orComeAsTheFacesNameThem) {
  Faces faces(3, 3);
  faces << 7, 2, 9, 2, 7, 0, 4, 9, 7;
  Faces expected(3, 3);
  expected << 0, 1, 2, 1, 0, 3, 4, 2, 0;
  EXPECT_EQ(compactVerticesByUse(faces, 11), (std::vector<int>{7, 2, 9, 0, 4}));
  EXPECT_EQ(faces, expected);
}

TEST(CompactVertices, ofNoFacesAreNone) {
  Faces none(0, 3);
  EXPECT_TRUE(compactVertices(none, 5).empty());
  EXPECT_TRUE(compactVerticesByUse(none, 5).empty());
  EXPECT_EQ(none.rows(), 0);
}

}  // namespace
}  // namespace posture
