// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/report/peak_memory.h>

#include <gtest/gtest.h>

#include <vector>

namespace posture {
namespace {

TEST(PeakMemory, remembersWhatIsFreedAgain) {
  const double before = peakMemoryMib();
  EXPECT_GT(before, 1);
  { const std::vector<char> block(std::size_t{64} << 20, 1); }
  // The system counts in steps of some pages.
  EXPECT_GT(peakMemoryMib(), before + 60);
  EXPECT_LT(peakMemoryMib(), before + 80);
}

}  // namespace
}  // namespace posture
