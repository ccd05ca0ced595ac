// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "finalists.h"
#include "support/shapes.h"
#include <vector>

namespace posture {
namespace {

TEST(Finalists, theOneThatWinsIsAmongTheForemost) {
  const TriangleMesh strip = test::grid(20, 1, 1, 0.05);
  const int n = static_cast<int>(strip.vertices.rows());
  const SpectralSurface target(strip, Matrix::Ones(n, 1), Vector::Zero(1));
  // Each takes all to one place: two of them to the same.
  std::vector<Finalist> finalists;
  for (int place : {0, 4, 5, 8, 12, 16, 17, 20}) {
    finalists.emplace_back();
    finalists.back().maps.forward.assign(n, place);
  }
  const std::vector<int> distinct = distinctFinalists(finalists, target, 0.07);
  ASSERT_EQ(distinct, (std::vector<int>{0, 1, 3, 4, 5, 7}));
  using Answers = std::vector<int>;
  EXPECT_EQ(foremost(distinct, finalists, target, 2, 4), (Answers{0, 1, 3, 4}));
  EXPECT_EQ(foremost(distinct, finalists, target, 4, 4), (Answers{0, 1, 3, 4}));
  EXPECT_EQ(foremost(distinct, finalists, target, 6, 4), (Answers{0, 1, 3, 5}));
  EXPECT_EQ(foremost(distinct, finalists, target, 7, 4), (Answers{0, 1, 3, 7}));
  EXPECT_EQ(foremost(distinct, finalists, target, 7, 9), distinct);
}

}  // namespace
}  // namespace posture
