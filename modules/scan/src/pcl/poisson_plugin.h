// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "points/oriented_points.h"

namespace posture {

/// PCL's Poisson surface whole, from an octree of the given depth. It lives in a shared library of
/// its own (modules/scan/poisson), loaded when it is asked for: PCL has this class compiled only,
/// in a library that links VTK. The loader finds the library by the run path of the program; the C
/// name is what the function is found by.
using PoissonFunction = void (*)(const OrientedPoints& oriented, int depth, TriangleMesh& mesh);
constexpr char POISSON_LIBRARY[] = "libposture_poisson.so";
constexpr char POISSON_FUNCTION[] = "posturePoissonSurface";

}  // namespace posture
