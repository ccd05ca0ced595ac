// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/rng.h>
#include <posture/matching/assignment.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <set>

namespace posture {
namespace {

CostMatrix randomCosts(int rows, int columns, Rng& rng, bool small_integers) {
  CostMatrix cost(rows, columns);
  for (int i = 0; i < cost.size(); ++i)
    cost.data()[i] = small_integers ? rng.below(4) - 1 : rng.normal();
  return cost;
}

/// The least sum over all one-to-one choices, by trying them.
double exhaustive(const CostMatrix& cost) {
  if (cost.rows() > cost.cols()) return exhaustive(cost.transpose());
  std::vector<int> columns(cost.cols());
  std::iota(columns.begin(), columns.end(), 0);
  double least = std::numeric_limits<double>::infinity();
  do {
    double sum = 0;
    for (int i = 0; i < cost.rows(); ++i) sum += cost(i, columns[i]);
    least = std::min(least, sum);
  } while (std::next_permutation(columns.begin(), columns.end()));
  return least;
}

/// A second implementation, by another method: the primal-dual form of the Hungarian algorithm
/// that adds one row after another (rows <= columns).
double hungarian(const CostMatrix& cost) {
  const int n = static_cast<int>(cost.rows()), m = static_cast<int>(cost.cols());
  std::vector<double> u(n + 1, 0), v(m + 1, 0);
  std::vector<int> row_of(m + 1, 0), way(m + 1, 0);
  for (int i = 1; i <= n; ++i) {
    row_of[0] = i;
    int j0 = 0;
    std::vector<double> least(m + 1, std::numeric_limits<double>::infinity());
    std::vector<char> used(m + 1, 0);
    do {
      used[j0] = 1;
      double delta = std::numeric_limits<double>::infinity();
      int j1 = 0;
      for (int j = 1; j <= m; ++j) {
        if (used[j]) continue;
        const double reduced = cost(row_of[j0] - 1, j - 1) - u[row_of[j0]] - v[j];
        if (reduced < least[j]) {
          least[j] = reduced;
          way[j] = j0;
        }
        if (least[j] < delta) {
          delta = least[j];
          j1 = j;
        }
      }
      for (int j = 0; j <= m; ++j)
        if (used[j]) {
          u[row_of[j]] += delta;
          v[j] -= delta;
        } else {
          least[j] -= delta;
        }
      j0 = j1;
    } while (row_of[j0] != 0);
    for (; j0 != 0; j0 = way[j0]) row_of[j0] = row_of[way[j0]];
  }
  double sum = 0;
  for (int j = 1; j <= m; ++j)
    if (row_of[j] != 0) sum += cost(row_of[j] - 1, j - 1);
  return sum;
}

/// One-to-one, complete, of the cost it claims, and proven by its duals.
void expectOptimal(const CostMatrix& cost, const Assignment& found) {
  const double tolerance = 1e-9 * (1 + cost.cwiseAbs().sum());
  std::set<int> used;
  double sum = 0;
  int assigned = 0;
  for (int i = 0; i < cost.rows(); ++i) {
    const int j = found.column_of_row[i];
    if (j < 0) continue;
    ++assigned;
    sum += cost(i, j);
    EXPECT_TRUE(used.insert(j).second) << "column " << j << " twice";
    EXPECT_NEAR(cost(i, j), found.row_dual[i] + found.column_dual[j], tolerance);
  }
  EXPECT_EQ(assigned, std::min(cost.rows(), cost.cols()));
  EXPECT_NEAR(found.cost, sum, tolerance);
  EXPECT_NEAR(found.row_dual.sum() + found.column_dual.sum(), sum, tolerance);
  for (int i = 0; i < cost.rows(); ++i)
    for (int j = 0; j < cost.cols(); ++j)
      EXPECT_GE(cost(i, j) - found.row_dual[i] - found.column_dual[j], -tolerance);
  EXPECT_TRUE(cost.rows() >= cost.cols() || found.column_dual.maxCoeff() <= tolerance);
  EXPECT_TRUE(cost.rows() <= cost.cols() || found.row_dual.maxCoeff() <= tolerance);
}

TEST(Assignment, isAsCheapAsExhaustiveSearch) {
  Rng rng(1);
  for (int rows = 1; rows <= 6; ++rows)
    for (int columns = 1; columns <= 6; ++columns)
      for (int trial = 0; trial < 20; ++trial) {
        const CostMatrix cost = randomCosts(rows, columns, rng, trial % 2 == 0);
        const Assignment found = minimumCostAssignment(cost);
        EXPECT_NEAR(found.cost, exhaustive(cost), 1e-9);
        expectOptimal(cost, found);
      }
}

TEST(Assignment, agreesWithASecondImplementation) {
  Rng rng(2);
  for (const auto& [rows, columns] : {std::pair(80, 80), {60, 90}, {90, 60}, {1, 200}})
    for (const bool ties : {false, true}) {
      const CostMatrix cost = randomCosts(rows, columns, rng, ties);
      const Assignment found = minimumCostAssignment(cost);
      const double expected = rows <= columns ? hungarian(cost) : hungarian(cost.transpose());
      EXPECT_NEAR(found.cost, expected, 1e-9);
      expectOptimal(cost, found);
    }
}

TEST(Assignment, ofPointsToThemselvesCostsNothing) {
  Rng rng(3);
  CostMatrix points = randomCosts(150, 3, rng, false), cost(150, 150);
  for (int i = 0; i < 150; ++i) cost.row(i) = (points.rowwise() - points.row(i)).rowwise().norm();
  const Assignment found = minimumCostAssignment(cost);
  EXPECT_NEAR(found.cost, 0, 1e-12);
  for (int i = 0; i < 150; ++i) EXPECT_EQ(found.column_of_row[i], i);
}

TEST(Assignment, takesNoRowsOrNoColumns) {
  EXPECT_TRUE(minimumCostAssignment(CostMatrix(0, 3)).column_of_row.empty());
  EXPECT_EQ(minimumCostAssignment(CostMatrix(2, 0)).column_of_row, std::vector<int>({-1, -1}));
}

TEST(Assignment, refusesWhatIsNotANumber) {
  CostMatrix cost = CostMatrix::Zero(2, 2);
  cost(1, 0) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(minimumCostAssignment(cost), std::invalid_argument);
}

}  // namespace
}  // namespace posture
