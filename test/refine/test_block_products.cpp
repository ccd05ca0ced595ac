// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/rng.h>
#include <posture/core/types.h>

#include <gtest/gtest.h>

#include "block_products.h"

namespace posture {
namespace {

using Multiply = void (*)(const float*, const float*, int, float*);

class BlockProducts : public testing::TestWithParam<Multiply> {};

TEST_P(BlockProducts, areThoseOfPlainSumsToTheLastDigit) {
  Rng rng(1);
  for (const int d : {0, 1, 12, 57, 400}) {
    Eigen::MatrixXf a(BLOCK_ROWS, d), b(BLOCK_ROWS, d), products(BLOCK_ROWS, BLOCK_ROWS);
    for (float& x : a.reshaped()) x = static_cast<float>(rng.normal());
    for (float& x : b.reshaped()) x = static_cast<float>(rng.normal());
    GetParam()(a.data(), b.data(), d, products.data());
    for (int j = 0; j < BLOCK_ROWS; ++j)
      for (int i = 0; i < BLOCK_ROWS; ++i) {
        float sum = 0;
        for (int k = 0; k < d; ++k) {
          const volatile float product = a(i, k) * b(j, k);  // not fused with the sum
          sum += product;
        }
        EXPECT_EQ(products(i, j), sum) << d << ": " << i << ' ' << j;
      }
  }
}

INSTANTIATE_TEST_SUITE_P(EveryProcessor,
                         BlockProducts,
                         testing::Values(multiplyRows, multiplyRowsPortably));

}  // namespace
}  // namespace posture
