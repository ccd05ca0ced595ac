// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/unions.h>

#include <gtest/gtest.h>

#include <vector>

namespace posture {
namespace {

TEST(Unions, areNamedByTheirLeastMember) {
  Unions sets(6);
  EXPECT_TRUE(sets.join(4, 5));
  EXPECT_TRUE(sets.join(3, 1));
  EXPECT_TRUE(sets.join(5, 3));
  EXPECT_FALSE(sets.join(1, 4));
  for (int x : {1, 3, 4, 5}) EXPECT_EQ(sets.root(x), 1);
  EXPECT_EQ(sets.root(0), 0);
  EXPECT_EQ(sets.root(2), 2);
  EXPECT_EQ(sets.roots(), (std::vector<int>{0, 1, 2, 1, 1, 1}));
  EXPECT_EQ(sets.sizes(), (std::vector<int>{1, 4, 1, 4, 4, 4}));
  EXPECT_EQ(sets.count(), 3);
}

TEST(Unions, ofNothingAreNone) {
  Unions none(0);
  EXPECT_EQ(none.count(), 0);
  EXPECT_TRUE(none.roots().empty());
  EXPECT_TRUE(none.sizes().empty());
}

}  // namespace
}  // namespace posture
