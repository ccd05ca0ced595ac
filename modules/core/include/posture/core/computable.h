// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/error.h>

namespace posture {

// Up to six lengths are multiplied: beyond these limits the products overflow or vanish, and what
// is told from them is wrong.

/// \param coordinate  the largest one.
inline void requireNotTooLarge(double coordinate) {
  constexpr double LARGEST = 1e50;
  if (!(coordinate < LARGEST)) throw InputError("has coordinates too large to compute with");
}

/// \param extent  0, for what is no surface anyway, passes.
inline void requireNotTooSmall(double extent) {
  constexpr double LEAST = 1e-50;
  if (extent > 0 && extent < LEAST) throw InputError("is too small to compute with");
}

/// Distances on a surface are kept in single precision, and squared.
inline void requireSurfaceExtent(double extent) {
  constexpr double LEAST = 1e-18, LARGEST = 1e18;
  if (extent > 0 && extent < LEAST) throw InputError("is too small to compute with");
  if (extent > LARGEST) throw InputError("is too large to compute with");
}

}  // namespace posture
