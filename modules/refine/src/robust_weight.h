// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace posture {

/// Geman and McClure's weight, given the square of a distance's ratio to the usual one.
inline double gemanMcClure(double squared_ratio) {
  const double near = 1 / (1 + squared_ratio);
  return near * near;
}

}  // namespace posture
