// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/types.h>

namespace posture {

/// Points of a surface with the outside told.
struct OrientedPoints {
  Points points;   ///< n x 3
  Points normals;  ///< n x 3, unit
};

}  // namespace posture
