// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "arap_steps.h"

#include <cstddef>
#include <cstring>

namespace posture {
namespace {

using Sparse = Eigen::SparseMatrix<double>;
/// A row in registers of AVX2, and without it.
using Four = double __attribute__((vector_size(4 * sizeof(double))));
using Two = double __attribute__((vector_size(2 * sizeof(double))));
struct TwoTwos {
  Two xy, z0;
};

[[gnu::always_inline]] inline TwoTwos operator+(const TwoTwos& a, const TwoTwos& b) {
  return {a.xy + b.xy, a.z0 + b.z0};
}
[[gnu::always_inline]] inline TwoTwos operator-(const TwoTwos& a, const TwoTwos& b) {
  return {a.xy - b.xy, a.z0 - b.z0};
}
[[gnu::always_inline]] inline TwoTwos operator*(double s, const TwoTwos& a) {
  return {s * a.xy, s * a.z0};
}

// Without AVX2 a Four is returned another way than with it: these take all by reference.
template <class Row>
[[gnu::always_inline]] inline void load(const WideRow& from, Row& row) {
  std::memcpy(&row, from.at, sizeof row);
}

template <class Row>
[[gnu::always_inline]] inline void store(const Row& row, WideRow& to) {
  std::memcpy(to.at, &row, sizeof row);
}

template <class Row>
[[gnu::always_inline]] inline void add(const Row& row, WideRow& to) {
  Row sum;
  load(to, sum);
  sum = sum + row;
  store(sum, to);
}

template <class Row>
[[gnu::always_inline]] inline void addCovariances(const std::vector<RigidEdge>& edges,
                                                  const std::vector<WideRow>& places,
                                                  std::vector<WideMatrix>& matrices) {
  for (const RigidEdge& e : edges) {
    Row i, j;
    load(places[e.i], i);
    load(places[e.j], j);
    const Row bent = e.weight * (i - j);
    for (int k = 0; k < 3; ++k) {
      const Row column = e.rest[k] * bent;
      add(column, matrices[e.i].column[k]);
      add(column, matrices[e.j].column[k]);
    }
  }
}

template <class Row>
[[gnu::always_inline]] inline void addRigidPull(const std::vector<RigidEdge>& edges,
                                                const std::vector<WideMatrix>& rotations,
                                                const Vector& stiffness,
                                                std::vector<WideRow>& pull) {
  for (const RigidEdge& e : edges) {
    Row turned[3];
    for (int k = 0; k < 3; ++k) {
      Row i, j;
      load(rotations[e.i].column[k], i);
      load(rotations[e.j].column[k], j);
      turned[k] = e.rest[k] * (stiffness[e.i] * i + stiffness[e.j] * j);
    }
    const Row along = 0.5 * e.weight * (turned[0] + turned[1] + turned[2]);
    Row j;
    load(pull[e.j], j);
    add(along, pull[e.i]);
    store(j - along, pull[e.j]);
  }
}

template <class Row>
[[gnu::always_inline]] inline void solve(const Sparse& lower,
                                         const Vector& inverse_diagonal,
                                         std::vector<WideRow>& x) {
  const int* const begin = lower.outerIndexPtr();
  const int* const row = lower.innerIndexPtr();
  const double* const value = lower.valuePtr();
  const int n = static_cast<int>(lower.cols());
  Row known, other;
  for (int j = 0; j < n; ++j) {
    load(x[j], known);
    for (int k = begin[j]; k < begin[j + 1]; ++k) {
      load(x[row[k]], other);
      store(other - value[k] * known, x[row[k]]);
    }
  }
  for (int j = n - 1; j >= 0; --j) {
    load(x[j], known);
    Row sum = inverse_diagonal[j] * known;
    for (int k = begin[j]; k < begin[j + 1]; ++k) {
      load(x[row[k]], other);
      sum = sum - value[k] * other;
    }
    store(sum, x[j]);
  }
}

constexpr ArapSteps PORTABLE{addCovariances<TwoTwos>, addRigidPull<TwoTwos>, solve<TwoTwos>};

#if defined(__x86_64__)
__attribute__((target("avx2"))) void addCovariancesByAvx2(const std::vector<RigidEdge>& edges,
                                                          const std::vector<WideRow>& places,
                                                          std::vector<WideMatrix>& matrices) {
  addCovariances<Four>(edges, places, matrices);
}

__attribute__((target("avx2"))) void addRigidPullByAvx2(const std::vector<RigidEdge>& edges,
                                                        const std::vector<WideMatrix>& rotations,
                                                        const Vector& stiffness,
                                                        std::vector<WideRow>& pull) {
  addRigidPull<Four>(edges, rotations, stiffness, pull);
}

__attribute__((target("avx2"))) void solveByAvx2(const Sparse& lower,
                                                 const Vector& inverse_diagonal,
                                                 std::vector<WideRow>& x) {
  solve<Four>(lower, inverse_diagonal, x);
}

constexpr ArapSteps BY_AVX2{addCovariancesByAvx2, addRigidPullByAvx2, solveByAvx2};
#endif

}  // namespace

std::vector<WideRow> wideRows(const Points& points) {
  std::vector<WideRow> rows(static_cast<std::size_t>(points.rows()));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto point = points.row(static_cast<Eigen::Index>(i));
    rows[i] = {{point[0], point[1], point[2], 0}};
  }
  return rows;
}

Points narrowRows(const std::vector<WideRow>& rows) {
  Points points(static_cast<Eigen::Index>(rows.size()), 3);
  for (std::size_t i = 0; i < rows.size(); ++i)
    points.row(static_cast<Eigen::Index>(i)) << rows[i].at[0], rows[i].at[1], rows[i].at[2];
  return points;
}

WideMatrix wide(const Eigen::Matrix3d& matrix) {
  WideMatrix columns;
  for (int j = 0; j < 3; ++j) columns.column[j] = {{matrix(0, j), matrix(1, j), matrix(2, j), 0}};
  return columns;
}

const ArapSteps& arapSteps() {
#if defined(__x86_64__)
  static const bool HAS_AVX2 = __builtin_cpu_supports("avx2") != 0;
  if (HAS_AVX2) return BY_AVX2;
#endif
  return PORTABLE;
}

const ArapSteps& portableArapSteps() { return PORTABLE; }

}  // namespace posture
