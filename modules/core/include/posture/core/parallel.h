// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <exception>
#include <vector>

namespace posture {

/// Calls body(0) .. body(count - 1), spread over the threads; the calls must not share what they
/// write. Of the exceptions thrown, the one of the lowest number is thrown on. A single call has
/// all threads for itself; loops within several have one each.
template <class Body>
void parallelFor(int count, const Body& body) {
  if (count == 1) return body(0);
  std::vector<std::exception_ptr> failures(count);
#pragma omp parallel for schedule(dynamic, 1)
  for (int i = 0; i < count; ++i) {
    try {
      body(i);
    } catch (...) {
      failures[i] = std::current_exception();
    }
  }
  for (const std::exception_ptr& failure : failures)
    if (failure) std::rethrow_exception(failure);
}

/// Calls one() and other(), at once where there are two threads.
template <class One, class Other>
void inParallel(const One& one, const Other& other) {
  parallelFor(2, [&](int which) { which == 0 ? one() : other(); });
}

/// Calls body(first, last) for consecutive ranges of 0 .. count - 1, spread over the threads.
template <class Body>
void forBlocks(int count, int block, const Body& body) {
  parallelFor((count + block - 1) / block,
              [&](int b) { body(b * block, std::min(count, (b + 1) * block)); });
}

template <class Body>
void forBlocks(int count, const Body& body) {
  constexpr int BLOCK = 1024;
  forBlocks(count, BLOCK, body);
}

/// Calls body(0) .. body(count - 1), spread over the threads in blocks of so many.
template <class Body>
void forEach(int count, int block, const Body& body) {
  forBlocks(count, block, [&](int first, int last) {
    for (int i = first; i < last; ++i) body(i);
  });
}

template <class Body>
void forEach(int count, const Body& body) {
  constexpr int BLOCK = 1024;
  forEach(count, BLOCK, body);
}

}  // namespace posture
