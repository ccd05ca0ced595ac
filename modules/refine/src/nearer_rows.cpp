// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nearer_rows.h"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <limits>

namespace posture {
namespace {

using FourFloats = float __attribute__((vector_size(16)));
using FourInts = int __attribute__((vector_size(16)));
using EightFloats = float __attribute__((vector_size(32)));
using EightInts = int __attribute__((vector_size(32)));

template <class Wide, class Number>
[[gnu::always_inline]] inline void load(const Number* from, Wide& wide) {
  std::memcpy(&wide, from, sizeof wide);
}

template <class Wide, class Number>
[[gnu::always_inline]] inline void store(const Wide& wide, Number* to) {
  std::memcpy(to, &wide, sizeof wide);
}

/// Without branches in the innermost loop. The nearest row of a is looked for only where one is
/// near enough.
template <class Floats, class Ints>
[[gnu::always_inline]] inline void take(const float* products,
                                        const BlockOfRows& a,
                                        const BlockOfRows& b) {
  constexpr int WIDTH = sizeof(Floats) / sizeof(float);
  constexpr float INFINITE = std::numeric_limits<float>::infinity();
  for (std::ptrdiff_t j = 0; j < BLOCK_ROWS; ++j) {
    const float* const product = products + BLOCK_ROWS * j;
    const Ints row_b = Ints{} + b.row[j];
    Floats best = Floats{} + INFINITE;
    for (int i = 0; i < BLOCK_ROWS; i += WIDTH) {
      Floats along, half_a, least_a;
      Ints nearest_a;
      load(product + i, along);
      load(a.half + i, half_a);
      load(a.least + i, least_a);
      load(a.nearest + i, nearest_a);
      const Floats to_b = b.half[j] - along, to_a = half_a - along;
      const Ints less = (to_b < least_a) | ((to_b == least_a) & (row_b < nearest_a));
      least_a = less ? to_b : least_a;
      nearest_a = less ? row_b : nearest_a;
      best = to_a < best ? to_a : best;
      store(least_a, a.least + i);
      store(nearest_a, a.nearest + i);
    }
    float least_b = INFINITE;
    for (int i = 0; i < WIDTH; ++i) least_b = std::min(least_b, best[i]);
    if (least_b > b.least[j]) continue;
    for (int i = 0; i < BLOCK_ROWS; ++i)
      if (a.half[i] - product[i] == least_b && (least_b < b.least[j] || a.row[i] < b.nearest[j])) {
        b.least[j] = least_b;
        b.nearest[j] = a.row[i];
      }
  }
}

#if defined(__x86_64__)
__attribute__((target("avx2"))) void takeByAvx2(const float* products,
                                                const BlockOfRows& a,
                                                const BlockOfRows& b) {
  take<EightFloats, EightInts>(products, a, b);
}
#endif

}  // namespace

void takeNearerPortably(const float* products, const BlockOfRows& a, const BlockOfRows& b) {
  take<FourFloats, FourInts>(products, a, b);
}

void takeNearer(const float* products, const BlockOfRows& a, const BlockOfRows& b) {
#if defined(__x86_64__)
  static const bool HAS_AVX2 = __builtin_cpu_supports("avx2") != 0;
  if (HAS_AVX2) return takeByAvx2(products, a, b);
#endif
  takeNearerPortably(products, a, b);
}

}  // namespace posture
