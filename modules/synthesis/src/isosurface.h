// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/core/types.h>

#include "field.h"

namespace posture::synthesis {

/// The skin of the field, marched through the six tetrahedra of each cube of a lattice that is
/// turned and shifted by `tessellation`. Closed, manifold, oriented outwards; triangles of any
/// shape.
TriangleMesh isosurface(const FleshField& field, double spacing, int tessellation);

}  // namespace posture::synthesis
