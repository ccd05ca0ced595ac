// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/mesh/minimum_cut.h>

#include <gtest/gtest.h>

namespace posture {
namespace {

TEST(MinimumCut, partsAChainWhereItIsWeakest) {
  MinimumCut cut(3);
  cut.joinSource(0, 5);
  cut.join(0, 1, 3);
  cut.join(1, 2, 2);
  cut.joinSink(2, 4);
  EXPECT_EQ(cut.onSinkSide(), (std::vector<char>{0, 0, 1}));
}

TEST(MinimumCut, partsAllWaysWhereTheyCostLeastTogether) {
  // Two ways from 0 to 3, one cheapest to cut at its begin, the other at its end.
  MinimumCut cut(4);
  cut.joinSource(0, 10);
  cut.join(0, 1, 1);
  cut.join(0, 2, 4);
  cut.join(1, 3, 2);
  cut.join(2, 3, 1);
  cut.joinSink(3, 10);
  EXPECT_EQ(cut.onSinkSide(), (std::vector<char>{0, 1, 0, 1}));
}

TEST(MinimumCut, leavesANodeToTheSideThatWantsItMore) {
  MinimumCut cut(2);
  cut.joinSource(0, 2);
  cut.joinSink(0, 1);
  cut.joinSource(1, 1);
  cut.joinSink(1, 2);
  EXPECT_EQ(cut.onSinkSide(), (std::vector<char>{0, 1}));
}

}  // namespace
}  // namespace posture
