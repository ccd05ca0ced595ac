// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/types.h>

namespace posture {

/// Whether single precision moves every finite point by far less than neighbours are apart.
bool fitFloats(const Points& points);

/// Whether single precision leaves points that differ different. Meshes have vertices next to each
/// other that are not one, where sheets touch.
bool differAsFloats(const Points& points);

}  // namespace posture
