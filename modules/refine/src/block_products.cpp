// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "block_products.h"

#include <cstddef>
#include <cstring>

namespace posture {
namespace {

using Four = float __attribute__((vector_size(16)));
using Eight = float __attribute__((vector_size(32)));

template <class Sums>
[[gnu::always_inline]] inline void put(const Sums& upper, const Sums& lower, float* at) {
  std::memcpy(at, &upper, sizeof upper);
  std::memcpy(at + sizeof upper / sizeof(float), &lower, sizeof lower);
}

/// A block of products, two registers of rows by four columns: as many sums as registers hold.
template <class Sums>
[[gnu::always_inline]] inline void multiply(const float* a, const float* b, int d, float* at) {
  constexpr int WIDTH = sizeof(Sums) / sizeof(float);
  Sums upper_0{}, upper_1{}, upper_2{}, upper_3{}, lower_0{}, lower_1{}, lower_2{}, lower_3{};
  for (int k = 0; k < d; ++k, a += BLOCK_ROWS, b += BLOCK_ROWS) {
    Sums upper, lower;
    std::memcpy(&upper, a, sizeof upper);
    std::memcpy(&lower, a + WIDTH, sizeof lower);
    upper_0 += upper * b[0];
    lower_0 += lower * b[0];
    upper_1 += upper * b[1];
    lower_1 += lower * b[1];
    upper_2 += upper * b[2];
    lower_2 += lower * b[2];
    upper_3 += upper * b[3];
    lower_3 += lower * b[3];
  }
  put(upper_0, lower_0, at);
  put(upper_1, lower_1, at += BLOCK_ROWS);
  put(upper_2, lower_2, at += BLOCK_ROWS);
  put(upper_3, lower_3, at += BLOCK_ROWS);
}

template <class Sums>
[[gnu::always_inline]] inline void multiplyAll(const float* a,
                                               const float* b,
                                               int d,
                                               float* products) {
  constexpr std::ptrdiff_t ROWS = 2 * sizeof(Sums) / sizeof(float);
  for (std::ptrdiff_t j = 0; j < BLOCK_ROWS; j += 4)
    for (std::ptrdiff_t i = 0; i < BLOCK_ROWS; i += ROWS)
      multiply<Sums>(a + i, b + j, d, products + BLOCK_ROWS * j + i);
}

#if defined(__x86_64__)
__attribute__((target("avx2"))) void multiplyByAvx2(const float* a,
                                                    const float* b,
                                                    int d,
                                                    float* products) {
  multiplyAll<Eight>(a, b, d, products);
}
#endif

}  // namespace

void multiplyRowsPortably(const float* a, const float* b, int d, float* products) {
  multiplyAll<Four>(a, b, d, products);
}

void multiplyRows(const float* a, const float* b, int d, float* products) {
#if defined(__x86_64__)
  static const bool HAS_AVX2 = __builtin_cpu_supports("avx2") != 0;
  if (HAS_AVX2) return multiplyByAvx2(a, b, d, products);
#endif
  multiplyRowsPortably(a, b, d, products);
}

}  // namespace posture
