// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace posture {

/// The nearest number a byte can hold; 0 for NaN.
inline std::uint8_t colorByte(double value) {
  return value >= 0 ? static_cast<std::uint8_t>(std::lround(std::min(value, 255.0)))
                    : std::uint8_t{0};
}

}  // namespace posture
