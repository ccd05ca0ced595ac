// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace posture {

constexpr int BLOCK_ROWS = 32;

/// a (32 x d) times b (32 x d) transposed. AVX2 is used where the processor has it, to the same
/// last digit: products are summed from the first column to the last, and no multiplication is
/// fused.
///
/// \param a, b      column-major
/// \param products  32 x 32, column-major: row i of a times row j of b at (i, j)
void multiplyRows(const float* a, const float* b, int d, float* products);

/// What it does where the processor has no AVX2.
void multiplyRowsPortably(const float* a, const float* b, int d, float* products);

}  // namespace posture
