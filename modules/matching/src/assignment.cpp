// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/error.h>
#include <posture/matching/assignment.h>

#include <limits>

namespace posture {
namespace {

/// Rows <= columns. Column prices start at 0 and only fall, and only while assigned: columns that
/// stay free keep price 0, which is what makes the rectangular problem's optimum one.
class Solver {
 public:
  explicit Solver(const CostMatrix& cost)
      : cost_(cost),
        rows_(static_cast<int>(cost.rows())),
        columns_(static_cast<int>(cost.cols())),
        column_of_(rows_, -1),
        row_of_(columns_, -1),
        price_(columns_, 0.0) {}

  Assignment solve() {
    for (int row : reduceRows()) augment(row);
    Assignment result;
    result.column_of_row = column_of_;
    result.row_dual.resize(rows_);
    result.column_dual = Eigen::Map<const Vector>(price_.data(), columns_);
    for (int i = 0; i < rows_; ++i) {
      result.row_dual[i] = cost_(i, column_of_[i]) - price_[column_of_[i]];
      result.cost += cost_(i, column_of_[i]);
    }
    return result;
  }

 private:
  void assign(int row, int column) {
    column_of_[row] = column;
    row_of_[column] = row;
  }

  /// Gives free rows their cheapest column, lowering its price as far as the second cheapest
  /// allows; a row that loses its column bids again. Returns the rows still free.
  std::vector<int> reduceRows() {
    std::vector<int> free_rows(rows_);
    for (int i = 0; i < rows_; ++i) free_rows[i] = i;
    // Two passes as in the original; bids are bounded because rounding can make them endless.
    for (int pass = 0; pass < 2; ++pass) {
      std::vector<int> still_free;
      long bids = 8L * rows_;
      for (std::size_t next = 0; next < free_rows.size();) {
        const int row = free_rows[next++];
        auto [first, second, gap] = twoCheapest(row);
        int loser = row_of_[first];
        if (gap > 0) {
          price_[first] -= gap;
        } else if (loser >= 0 && second >= 0) {
          first = second;
          loser = row_of_[first];
        }
        assign(row, first);
        if (loser < 0) continue;
        column_of_[loser] = -1;
        if (gap > 0 && --bids > 0)
          free_rows[--next] = loser;
        else
          still_free.push_back(loser);
      }
      free_rows = std::move(still_free);
    }
    return free_rows;
  }

  struct TwoCheapest {
    int first, second;
    double gap;
  };

  TwoCheapest twoCheapest(int row) const {
    constexpr double INFINITE = std::numeric_limits<double>::infinity();
    int first = 0, second = -1;
    double least = INFINITE, next = INFINITE;
    for (int j = 0; j < columns_; ++j) {
      const double reduced = cost_(row, j) - price_[j];
      if (reduced >= next) continue;
      if (reduced >= least) {
        next = reduced;
        second = j;
      } else {
        next = least;
        second = first;
        least = reduced;
        first = j;
      }
    }
    if (next == INFINITE) return {first, -1, 0};
    return {first, second, next - least};
  }

  /// Dijkstra's search from a free row over reduced costs to the nearest free column.
  void augment(int free_row) {
    std::vector<double> distance(columns_);
    std::vector<int> from_row(columns_, free_row), open(columns_), settled;
    for (int j = 0; j < columns_; ++j) {
      distance[j] = cost_(free_row, j) - price_[j];
      open[j] = j;
    }
    int sink = -1;
    double reached = 0;
    while (true) {
      std::size_t best = 0;
      for (std::size_t k = 1; k < open.size(); ++k)
        if (distance[open[k]] < distance[open[best]]) best = k;
      const int column = open[best];
      reached = distance[column];
      if (row_of_[column] < 0) {
        sink = column;
        break;
      }
      settled.push_back(column);
      open[best] = open.back();
      open.pop_back();
      const int row = row_of_[column];
      const double offset = reached - (cost_(row, column) - price_[column]);
      for (int j : open) {
        const double through = offset + cost_(row, j) - price_[j];
        if (through < distance[j]) {
          distance[j] = through;
          from_row[j] = row;
        }
      }
    }
    for (int j : settled) price_[j] += distance[j] - reached;
    for (int column = sink;;) {
      const int row = from_row[column], previous = column_of_[row];
      assign(row, column);
      if (row == free_row) break;
      column = previous;
    }
  }

  const CostMatrix& cost_;
  int rows_, columns_;
  std::vector<int> column_of_, row_of_;
  std::vector<double> price_;
};

}  // namespace

Assignment minimumCostAssignment(const CostMatrix& cost) {
  require(cost.allFinite(), "minimumCostAssignment: a cost is not finite");
  if (cost.size() == 0) {
    Assignment none;
    none.column_of_row.assign(cost.rows(), -1);
    none.row_dual = Vector::Zero(cost.rows());
    none.column_dual = Vector::Zero(cost.cols());
    return none;
  }
  if (cost.rows() <= cost.cols()) return Solver(cost).solve();
  const CostMatrix transposed = cost.transpose();
  const Assignment dual = Solver(transposed).solve();
  Assignment result;
  result.column_of_row.assign(cost.rows(), -1);
  for (int j = 0; j < transposed.rows(); ++j) result.column_of_row[dual.column_of_row[j]] = j;
  result.cost = dual.cost;
  result.row_dual = dual.column_dual;
  result.column_dual = dual.row_dual;
  return result;
}

}  // namespace posture
