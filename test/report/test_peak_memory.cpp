// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/report/peak_memory.h>

#include <gtest/gtest.h>

#include <vector>

namespace posture {
namespace {

TEST(PeakMemory, growsAndDoesNotFall) {
  const double before = peakMemoryMib();
  EXPECT_GT(before, 1);
  double during = 0;
  {
    const std::vector<char> block(std::size_t{64} << 20, 1);
    during = peakMemoryMib() + 0.0 * block.back();
  }
  EXPECT_GE(during, before + 60);
  EXPECT_LT(during, before + 80);
  EXPECT_GE(peakMemoryMib(), during);
}

}  // namespace
}  // namespace posture
