// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/rng.h>

#include <gtest/gtest.h>

#include <cstdint>

namespace posture {
namespace {

TEST(Rng, isSplitMix64) {
  // The published figures for this seed.
  Rng rng(1234567);
  for (std::uint64_t expected : {6457827717110365317ull,
                                 3203168211198807973ull,
                                 9817491932198370423ull,
                                 4593380528125082431ull,
                                 16408922859458223821ull})
    EXPECT_EQ(rng.next(), expected);
}

TEST(Rng, coversItsRanges) {
  Rng rng(1);
  constexpr int N = 20000;
  int counts[5] = {};
  double sum = 0, normal = 0, squared = 0;
  for (int i = 0; i < N; ++i) {
    const double u = rng.uniform(), x = rng.normal();
    ASSERT_GE(u, 0);
    ASSERT_LT(u, 1);
    sum += u;
    ++counts[rng.below(5)];
    normal += x;
    squared += x * x;
  }
  // Five standard errors.
  EXPECT_NEAR(sum / N, 0.5, 0.011);
  EXPECT_NEAR(normal / N, 0, 0.036);
  EXPECT_NEAR(squared / N, 1, 0.05);
  for (int count : counts) EXPECT_NEAR(count, N / 5, 283);
}

}  // namespace
}  // namespace posture
