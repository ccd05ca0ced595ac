// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/parallel.h>

#include <algorithm>

namespace posture {

/// Calls body(first, last) for consecutive ranges of 0 .. count - 1, spread over the threads.
template <class Body>
void forBlocks(int count, const Body& body) {
  constexpr int BLOCK = 1024;
  parallelFor((count + BLOCK - 1) / BLOCK,
              [&](int block) { body(block * BLOCK, std::min(count, (block + 1) * BLOCK)); });
}

/// Calls body(0) .. body(count - 1), spread over the threads in blocks.
template <class Body>
void forEach(int count, const Body& body) {
  forBlocks(count, [&](int first, int last) {
    for (int i = first; i < last; ++i) body(i);
  });
}

}  // namespace posture
