// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/rng.h>

#include <gtest/gtest.h>

#include "nearest_rows.h"
#include <cmath>
#include <string>
#include <vector>

namespace posture {
namespace {

Eigen::MatrixXf randomRows(int rows, int dimensions, Rng& rng) {
  Eigen::MatrixXf m(rows, dimensions);
  for (int j = 0; j < dimensions; ++j)
    for (int i = 0; i < rows; ++i) m(i, j) = static_cast<float>(rng.uniform());
  return m;
}

/// In double precision, one by one.
int nearestOf(const Eigen::MatrixXf& rows, const Eigen::RowVectorXf& row) {
  Eigen::Index nearest = 0;
  (rows.cast<double>().rowwise() - row.cast<double>()).rowwise().squaredNorm().minCoeff(&nearest);
  return static_cast<int>(nearest);
}

struct Search {
  const char* name;
  void (*find)(const Eigen::MatrixXf&,
               const Eigen::MatrixXf&,
               std::vector<int>&,
               std::vector<int>&);
};

class NearestRows : public testing::TestWithParam<Search> {};

void expectNearest(const Search& search, const Eigen::MatrixXf& a, const Eigen::MatrixXf& b) {
  std::vector<int> forward, backward;
  search.find(a, b, forward, backward);
  ASSERT_EQ(forward.size(), a.rows());
  ASSERT_EQ(backward.size(), b.rows());
  for (int i = 0; i < a.rows(); ++i) EXPECT_EQ(forward[i], nearestOf(b, a.row(i))) << i;
  for (int j = 0; j < b.rows(); ++j) EXPECT_EQ(backward[j], nearestOf(a, b.row(j))) << j;
}

TEST_P(NearestRows, findsWhatLookingAtAllFinds) {
  Rng rng(7);
  for (int dimensions : {2, 3, 12})
    expectNearest(GetParam(), randomRows(500, dimensions, rng), randomRows(333, dimensions, rng));
}

TEST_P(NearestRows, findsItWhereTheTwoSetsAreFarApart) {
  Rng rng(8);
  Eigen::MatrixXf far = randomRows(200, 3, rng);
  far.col(1).array() += 5;
  expectNearest(GetParam(), randomRows(300, 3, rng), far);
}

TEST_P(NearestRows, leavesRowsOutThatAreNoNumbers) {
  Rng rng(10);
  const Eigen::MatrixXf a = randomRows(200, 3, rng), b = randomRows(150, 3, rng);
  Eigen::MatrixXf with_bad(a.rows() + 2, 3);
  with_bad << a.topRows(60), Eigen::RowVector3f::Constant(NAN), a.bottomRows(140),
      Eigen::RowVector3f(0, INFINITY, 0);
  std::vector<int> forward, backward;
  GetParam().find(with_bad, b, forward, backward);
  ASSERT_EQ(forward.size(), 202u);
  for (int i = 0; i < 200; ++i) EXPECT_EQ(forward[i < 60 ? i : i + 1], nearestOf(b, a.row(i))) << i;
  for (int bad : {60, 201}) EXPECT_TRUE(forward[bad] >= 0 && forward[bad] < 150);
  for (int j = 0; j < 150; ++j) {
    const int found = nearestOf(a, b.row(j));
    EXPECT_EQ(backward[j], found < 60 ? found : found + 1) << j;
  }
  GetParam().find(Eigen::MatrixXf::Constant(3, 3, NAN), b, forward, backward);
  EXPECT_EQ(forward, std::vector<int>(3, 0));
  EXPECT_EQ(backward, std::vector<int>(150, 0));
}

TEST_P(NearestRows, takesSetsSmallerThanAGroup) {
  Rng rng(9);
  expectNearest(GetParam(), randomRows(1, 4, rng), randomRows(1, 4, rng));
  expectNearest(GetParam(), randomRows(5, 4, rng), randomRows(100, 4, rng));
}

TEST_P(NearestRows, takesTheFirstOfEquallyNearRows) {
  // Small integers: all distances are exact.
  constexpr int n = 400, sites = 10;
  Eigen::MatrixXf a(n, 2), b(n, 2);
  for (int i = 0; i < n; ++i) {
    a.row(i) << static_cast<float>(i % sites), 0.0f;
    b.row(i) << static_cast<float>(i * 7 % sites), 1.0f;
  }
  std::vector<int> forward, backward;
  GetParam().find(a, b, forward, backward);
  for (int i = 0; i < n; ++i) {
    EXPECT_EQ(forward[i], i % sites * 3 % sites) << i;
    EXPECT_EQ(backward[i], i * 7 % sites) << i;
  }
}

INSTANTIATE_TEST_SUITE_P(Both,
                         NearestRows,
                         testing::Values(Search{"amongAll", nearestBothWays},
                                         Search{"amongGroups", nearestAmongGroups}),
                         [](const auto& search) { return std::string(search.param.name); });

}  // namespace
}  // namespace posture
