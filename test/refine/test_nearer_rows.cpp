// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/rng.h>

#include <Eigen/Core>
#include <gtest/gtest.h>

#include "nearer_rows.h"
#include <limits>
#include <numeric>
#include <vector>

namespace posture {
namespace {

constexpr float INFINITE = std::numeric_limits<float>::infinity();

/// Points on a line, numbered from `first` on.
struct Line {
  Line(int count, int first, Rng& rng)
      : points(Eigen::VectorXf::Zero(BLOCK_ROWS)),
        half(BLOCK_ROWS, INFINITE),
        least(BLOCK_ROWS, INFINITE),
        row(BLOCK_ROWS, std::numeric_limits<int>::max()),
        nearest(BLOCK_ROWS, 0) {
    std::iota(row.begin(), row.begin() + count, first);
    for (int i = 0; i < count; ++i) {
      points[i] = static_cast<float>(static_cast<int>(50 * rng.uniform()));  // some at one place
      half[i] = 0.5f * points[i] * points[i];
    }
  }

  BlockOfRows block() { return {half.data(), row.data(), least.data(), nearest.data()}; }

  Eigen::VectorXf points;
  std::vector<float> half, least;
  std::vector<int> row, nearest;
};

int nearestOf(const std::vector<Line>& lines, float place, int count) {
  float least = INFINITE;
  int nearest = 0;
  for (const Line& line : lines)
    for (int i = 0; i < count; ++i) {
      const float distance = (line.points[i] - place) * (line.points[i] - place);
      if (!(distance < least || (distance == least && line.row[i] < nearest))) continue;
      least = distance;
      nearest = line.row[i];
    }
  return nearest;
}

using Take = void (*)(const float*, const BlockOfRows&, const BlockOfRows&);

class NearerRows : public testing::TestWithParam<Take> {};

TEST_P(NearerRows, areThoseOfLeastNumberAmongTheNearest) {
  for (const int count : {BLOCK_ROWS, 21, 1}) {
    Rng rng(2);
    std::vector<Line> a, b;
    for (int k = 0; k < 4; ++k) {
      a.emplace_back(count, 1000 - 100 * k, rng);
      b.emplace_back(count, 7 + 50 * k, rng);
    }
    for (Line& of_a : a)
      for (Line& of_b : b) {
        float products[BLOCK_ROWS * BLOCK_ROWS];
        multiplyRows(of_a.points.data(), of_b.points.data(), 1, products);
        GetParam()(products, of_a.block(), of_b.block());
      }
    for (int k = 0; k < 4; ++k)
      for (int i = 0; i < count; ++i) {
        EXPECT_EQ(a[k].nearest[i], nearestOf(b, a[k].points[i], count)) << count << ' ' << i;
        EXPECT_EQ(b[k].nearest[i], nearestOf(a, b[k].points[i], count)) << count << ' ' << i;
      }
  }
}

INSTANTIATE_TEST_SUITE_P(EveryProcessor,
                         NearerRows,
                         testing::Values(takeNearer, takeNearerPortably));

}  // namespace
}  // namespace posture
