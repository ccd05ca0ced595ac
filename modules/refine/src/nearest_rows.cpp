// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nearest_rows.h"

#include "block_products.h"
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <tuple>
#include <utility>

namespace posture {
namespace {

using Eigen::MatrixXf;
using Eigen::VectorXf;

constexpr int GROUP = BLOCK_ROWS;
constexpr float INFINITE = std::numeric_limits<float>::infinity();

/// In which order points are put into groups.
enum class Order { AS_GIVEN, NEAR_EACH_OTHER };

/// Points, GROUP consecutive ones at a time, with the nearest points of another set found so far.
/// Those that are not finite are left out.
struct GroupedPoints {
  GroupedPoints(const MatrixXf& rows, Order order);

  int groups() const { return (static_cast<int>(row.size()) + GROUP - 1) / GROUP; }
  int size(int group) const {
    return std::min(GROUP, static_cast<int>(row.size()) - group * GROUP);
  }

  /// GROUP rows, column-major; zeros where there are fewer points.
  const float* points(int group) const { return blocks.col(group).data(); }

  /// Half the squared distance within which each point of the group has a neighbour.
  float reach(int group) const {
    const int first = group * GROUP;
    return (least.segment(first, size(group)) + half.segment(first, size(group))).maxCoeff();
  }

  /// For each row as given.
  std::vector<int> found() const {
    std::vector<int> found(given_count, 0);
    for (std::size_t i = 0; i < row.size(); ++i) found[row[i]] = nearest[i];
    return found;
  }

  std::size_t given_count;   // of points
  int dimensions;            // of each
  std::vector<int> row;      // as given
  MatrixXf blocks;           // a column a group
  VectorXf half;             // of the squared norms
  VectorXf least;            // half the squared distance to the nearest, less `half`
  std::vector<int> nearest;  // its row

 private:
  void arrange(const MatrixXf& given, int begin, int end);
};

GroupedPoints::GroupedPoints(const MatrixXf& rows, Order order)
    : given_count(rows.rows()), dimensions(static_cast<int>(rows.cols())) {
  const MatrixXf given = rows.transpose();
  const VectorXf squared = given.colwise().squaredNorm();
  for (int i = 0; i < squared.size(); ++i)
    if (std::isfinite(squared[i])) row.push_back(i);
  const auto finite = static_cast<int>(row.size());
  if (order == Order::NEAR_EACH_OTHER) arrange(given, 0, finite);
  blocks = MatrixXf::Zero(GROUP * dimensions, groups());
  for (int g = 0; g < groups(); ++g)
    for (int i = 0; i < size(g); ++i)
      for (int d = 0; d < dimensions; ++d) blocks(GROUP * d + i, g) = given(d, row[g * GROUP + i]);
  half = 0.5f * squared(row);
  least = VectorXf::Constant(finite, INFINITE);
  nearest.assign(finite, 0);
}

/// Halves a range where it is widest, down to groups of which all but the last are full.
void GroupedPoints::arrange(const MatrixXf& given, int begin, int end) {
  const int count = (end - begin + GROUP - 1) / GROUP;
  if (count <= 1) return;
  VectorXf from = given.col(row[begin]), to = from;
  for (int i = begin + 1; i < end; ++i) {
    from = from.cwiseMin(given.col(row[i]));
    to = to.cwiseMax(given.col(row[i]));
  }
  Eigen::Index widest = 0;
  (to - from).maxCoeff(&widest);
  const int middle = begin + GROUP * ((count + 1) / 2);
  std::nth_element(row.begin() + begin, row.begin() + middle, row.begin() + end, [&](int x, int y) {
    return std::make_pair(given(widest, x), x) < std::make_pair(given(widest, y), y);
  });
  arrange(given, begin, middle);
  arrange(given, middle, end);
}

/// Two groups and a lower bound of half the squared distances between them.
struct GroupPair {
  float bound;
  int a, b;
};

/// The corners of the boxes around groups, a column each.
struct Boxes {
  explicit Boxes(const GroupedPoints& of)
      : low(of.dimensions, of.groups()), high(of.dimensions, of.groups()) {
    for (int g = 0; g < of.groups(); ++g) {
      const Eigen::Map<const MatrixXf> points(of.points(g), GROUP, of.dimensions);
      low.col(g) = points.topRows(of.size(g)).colwise().minCoeff();
      high.col(g) = points.topRows(of.size(g)).colwise().maxCoeff();
    }
  }

  MatrixXf low, high;
};

/// Pairs with the least bounds first.
std::vector<GroupPair> groupPairs(const GroupedPoints& a, const GroupedPoints& b) {
  if (a.groups() == 0 || b.groups() == 0) return {};
  // What half a squared distance may be off by when it comes from a product.
  const float rounding = 1e-5f * (a.half.maxCoeff() + b.half.maxCoeff());
  const Boxes box_a(a), box_b(b);
  std::vector<GroupPair> pairs;
  pairs.reserve(static_cast<std::size_t>(a.groups()) * b.groups());
  for (int j = 0; j < b.groups(); ++j)
    for (int i = 0; i < a.groups(); ++i) {
      const auto gap =
          (box_a.low.col(i) - box_b.high.col(j)).cwiseMax(box_b.low.col(j) - box_a.high.col(i));
      pairs.push_back({0.5f * gap.cwiseMax(0.0f).squaredNorm() - rounding, i, j});
    }
  std::sort(pairs.begin(), pairs.end(), [](const GroupPair& x, const GroupPair& y) {
    return std::tie(x.bound, x.a, x.b) < std::tie(y.bound, y.a, y.b);
  });
  return pairs;
}

/// All points of two groups with each other; one block of products serves both directions.
void compare(GroupedPoints& a, int group_a, GroupedPoints& b, int group_b) {
  const int first_a = group_a * GROUP, first_b = group_b * GROUP;
  const int na = a.size(group_a), nb = b.size(group_b);
  float products[GROUP * GROUP];
  multiplyRows(a.points(group_a), b.points(group_b), a.dimensions, products);
  const float* const half = a.half.data() + first_a;
  const int* const row = a.row.data() + first_a;
  float* const least = a.least.data() + first_a;
  int* const nearest = a.nearest.data() + first_a;
  for (int j = 0; j < nb; ++j) {
    const float* const product = products + GROUP * j;
    const float offset = b.half[first_b + j];
    const int row_b = b.row[first_b + j];
    float best = INFINITE;
    // Without branches: vectorized.
    for (int i = 0; i < na; ++i) {
      const float d = offset - product[i];
      const bool less = (d < least[i]) | ((d == least[i]) & (row_b < nearest[i]));
      least[i] = less ? d : least[i];
      nearest[i] = less ? row_b : nearest[i];
    }
    for (int i = 0; i < na; ++i) best = std::min(best, half[i] - product[i]);
    float& least_b = b.least[first_b + j];
    int& nearest_b = b.nearest[first_b + j];
    if (best > least_b) continue;
    for (int i = 0; i < na; ++i)
      if (half[i] - product[i] == best && (best < least_b || row[i] < nearest_b)) {
        least_b = best;
        nearest_b = row[i];
      }
  }
}

}  // namespace

void nearestBothWays(const MatrixXf& rows_a,
                     const MatrixXf& rows_b,
                     std::vector<int>& forward,
                     std::vector<int>& backward) {
  GroupedPoints a(rows_a, Order::AS_GIVEN), b(rows_b, Order::AS_GIVEN);
  for (int j = 0; j < b.groups(); ++j)
    for (int i = 0; i < a.groups(); ++i) compare(a, i, b, j);
  forward = a.found();
  backward = b.found();
}

void nearestAmongGroups(const MatrixXf& rows_a,
                        const MatrixXf& rows_b,
                        std::vector<int>& forward,
                        std::vector<int>& backward) {
  GroupedPoints a(rows_a, Order::NEAR_EACH_OTHER), b(rows_b, Order::NEAR_EACH_OTHER);
  std::vector<float> reach_a(a.groups(), INFINITE), reach_b(b.groups(), INFINITE);
  for (const GroupPair& pair : groupPairs(a, b)) {
    if (pair.bound > std::max(reach_a[pair.a], reach_b[pair.b])) continue;
    compare(a, pair.a, b, pair.b);
    reach_a[pair.a] = a.reach(pair.a);
    reach_b[pair.b] = b.reach(pair.b);
  }
  forward = a.found();
  backward = b.found();
}

}  // namespace posture
