// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/types.h>

namespace posture::test {

/// rows x columns quads cut into triangles over [0, width] x [0, height], z = 0.
TriangleMesh grid(int columns, int rows, double width, double height);

/// The unit sphere: an icosahedron subdivided `levels` times.
TriangleMesh sphere(int levels);

/// A strip of the given length and width, bent along its length into an arc of `angle` radians
/// without stretching: vertex numbering is that of grid().
TriangleMesh bentStrip(int columns, int rows, double length, double width, double angle);

}  // namespace posture::test
