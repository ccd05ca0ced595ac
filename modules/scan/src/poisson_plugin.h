// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "smoothing.h"

namespace posture {

/// PCL's Poisson surface whole, from an octree of the given depth. It lives in a shared library of
/// its own (modules/scan/poisson), loaded when it is asked for: PCL has this class compiled only,
/// in a library that links VTK. The C name is what it is found by.
using PoissonFunction = void (*)(const OrientedPoints& oriented, int depth, TriangleMesh& mesh);
constexpr char POISSON_FUNCTION[] = "posturePoissonSurface";

}  // namespace posture
