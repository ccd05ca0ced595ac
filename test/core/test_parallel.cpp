// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/parallel.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <omp.h>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace posture {
namespace {

/// With more threads than there may be processors.
class Parallel : public testing::Test {
 protected:
  Parallel() { omp_set_num_threads(4); }
  ~Parallel() override { omp_set_num_threads(threads_); }

 private:
  const int threads_ = omp_get_max_threads();
};

TEST_F(Parallel, everyIndexComesOnce) {
  for (int count : {0, 1, 1023, 1024, 1025, 3000}) {
    std::vector<int> alone(count, 0), in_blocks(count, 0);
    parallelFor(count, [&](int i) { ++alone[i]; });
    forEach(count, 7, [&](int i) { ++in_blocks[i]; });
    EXPECT_EQ(alone, std::vector<int>(count, 1));
    EXPECT_EQ(in_blocks, alone);
  }
}

TEST_F(Parallel, blocksAreTheSameWithAnyNumberOfThreads) {
  std::vector<int> ends(1000, 0);
  forBlocks(1000, 300, [&](int first, int last) { ends[first] = last; });
  std::vector<int> expected(1000, 0);
  expected[0] = 300, expected[300] = 600, expected[600] = 900, expected[900] = 1000;
  EXPECT_EQ(ends, expected);
}

TEST_F(Parallel, loopsWithinASingleCallHaveAllThreads) {
  for (const auto& [calls, threads] : {std::pair(1, 4), std::pair(2, 1)}) {
    std::vector<int> within(2, 0);
    parallelFor(calls, [&](int i) {
      std::vector<int> seen(2, 0);
      parallelFor(2, [&](int j) { seen[j] = omp_get_num_threads(); });
      within[i] = *std::max_element(seen.begin(), seen.end());
    });
    EXPECT_EQ(within[0], threads) << calls;
  }
}

TEST_F(Parallel, theFirstFailureIsThrownWhenAllIsDone) {
  std::vector<char> done(50, 0);
  try {
    parallelFor(50, [&](int i) {
      done[i] = 1;
      if (i == 7 || i == 3 || i == 40) throw std::runtime_error(std::to_string(i));
    });
    FAIL() << "nothing was thrown";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "3");
  }
  EXPECT_EQ(std::count(done.begin(), done.end(), 1), 50);
}

}  // namespace
}  // namespace posture
