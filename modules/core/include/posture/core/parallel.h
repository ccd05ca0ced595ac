// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <exception>
#include <vector>

namespace posture {

/// Calls body(0) .. body(count - 1), spread over the threads; the calls must not share what they
/// write. Of the exceptions thrown, the one of the lowest number is thrown on.
template <class Body>
void parallelFor(int count, const Body& body) {
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

}  // namespace posture
