// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/correspondence.h>

namespace posture {

/// One side laid onto the other one, in terms of the vertices and faces as they were given.
struct LaidSide {
  double scale = 1;               ///< a length of it times this is one of the other side
  double trust = 0;               ///< of the map
  Correspondence correspondence;  ///< a row a vertex
  Points deformed;                ///< n x 3, in the other side's frame
};

}  // namespace posture
