// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "block_products.h"

namespace posture {

/// BLOCK_ROWS points of a set, and the nearest points of another set found so far.
struct BlockOfRows {
  const float* half;  ///< of the squared norms; infinite where there is no point
  const int* row;     ///< their numbers
  float* least;       ///< half the squared distance to the nearest, less `half`
  int* nearest;       ///< its number
};

/// Takes over what of each block is nearer to the rows of the other than what was found so far; of
/// equally near ones the least number. AVX2 is used where the processor has it, to the same result.
/// \param products  of all rows of a and b, as multiplyRows() has them.
void takeNearer(const float* products, const BlockOfRows& a, const BlockOfRows& b);

/// What it does where the processor has no AVX2.
void takeNearerPortably(const float* products, const BlockOfRows& a, const BlockOfRows& b);

}  // namespace posture
