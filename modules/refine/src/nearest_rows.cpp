// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nearest_rows.h"

#include "block_products.h"
#include "nearer_rows.h"
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

  int groups() const { return static_cast<int>(row.size()) / GROUP; }
  int size(int group) const { return std::min(GROUP, count - group * GROUP); }

  /// GROUP rows, column-major; zeros where there are fewer points.
  const float* points(int group) const { return blocks.col(group).data(); }

  BlockOfRows block(int group) {
    const int first = group * GROUP;
    return {half.data() + first, row.data() + first, least.data() + first, nearest.data() + first};
  }

  /// Half the squared distance within which each point of the group has a neighbour.
  float reach(int group) const {
    const int first = group * GROUP;
    return (least.segment(first, size(group)) + half.segment(first, size(group))).maxCoeff();
  }

  /// For each row as given.
  std::vector<int> found() const {
    std::vector<int> found(given_count, 0);
    for (int i = 0; i < count; ++i) found[row[i]] = nearest[i];
    return found;
  }

  std::size_t given_count;  // of points
  int dimensions;           // of each
  int count = 0;            // of those that are finite
  MatrixXf blocks;          // a column a group
  // Up to the end of the last group.
  std::vector<int> row;      // as given
  VectorXf half;             // of the squared norms; infinite where there are fewer points
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
  count = static_cast<int>(row.size());
  if (order == Order::NEAR_EACH_OTHER) arrange(given, 0, count);
  const std::size_t full_groups = (count + GROUP - 1) / GROUP;
  row.resize(GROUP * full_groups, std::numeric_limits<int>::max());
  blocks = MatrixXf::Zero(Eigen::Index{GROUP} * dimensions, groups());
  for (int g = 0; g < groups(); ++g)
    for (int i = 0; i < size(g); ++i)
      for (int d = 0; d < dimensions; ++d) blocks(GROUP * d + i, g) = given(d, row[g * GROUP + i]);
  half = VectorXf::Constant(static_cast<Eigen::Index>(row.size()), INFINITE);
  for (int i = 0; i < count; ++i) half[i] = 0.5f * squared[row[i]];
  least = VectorXf::Constant(half.size(), INFINITE);
  nearest.assign(row.size(), 0);
}

/// Halves a range where it is widest, down to groups of which all but the last are full.
void GroupedPoints::arrange(const MatrixXf& given, int begin, int end) {
  const int group_count = (end - begin + GROUP - 1) / GROUP;
  if (group_count <= 1) return;
  VectorXf from = given.col(row[begin]), to = from;
  for (int i = begin + 1; i < end; ++i) {
    from = from.cwiseMin(given.col(row[i]));
    to = to.cwiseMax(given.col(row[i]));
  }
  Eigen::Index widest = 0;
  (to - from).maxCoeff(&widest);
  const int middle = begin + GROUP * ((group_count + 1) / 2);
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
  const float rounding =
      1e-5f * (a.half.head(a.count).maxCoeff() + b.half.head(b.count).maxCoeff());
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
  float products[GROUP * GROUP];
  multiplyRows(a.points(group_a), b.points(group_b), a.dimensions, products);
  takeNearer(products, a.block(group_a), b.block(group_b));
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
