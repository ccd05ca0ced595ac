// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/types.h>

#include <cstdint>

namespace posture::test {

/// rows x columns quads cut into triangles over [0, width] x [0, height], z = 0.
TriangleMesh grid(int columns, int rows, double width, double height);

/// The unit sphere: an icosahedron subdivided `levels` times.
TriangleMesh sphere(int levels);

/// A strip of the given length and width, bent along its length into an arc of `angle` radians
/// without stretching: vertex numbering is that of grid().
TriangleMesh bentStrip(int columns, int rows, double length, double width, double angle);

/// count x 3, each coordinate standard normal.
Points randomPoints(int count, std::uint64_t seed);

/// n x n straight distances.
Matrix pairwise(const Points& points);

}  // namespace posture::test
